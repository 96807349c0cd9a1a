#pragma once

#include <QAction>
#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <QWidget>

namespace glissade {

/// What is being done in the background, how far it is, and a button that ends it. What is done at
/// once does not make it flash.
class BusyBar final : public QWidget {
  Q_OBJECT

 public:
  BusyBar(QAction* cancel, QWidget* parent);

  void begin(const QString& what);
  void setShare(double share);
  void end();

 private:
  QLabel* what_;
  QProgressBar* progress_;
  QTimer patience_;
};

}  // namespace glissade
