#pragma once

#include <QAction>
#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <QWidget>

namespace glissade {

/// What is being done in the background, for how long and how far it is, and a button that ends it. What is done at
/// once does not make it flash.
class BusyBar final : public QWidget {
  Q_OBJECT

 public:
  BusyBar(QAction* cancel, QWidget* parent);

  void begin(const QString& what, const QElapsedTimer& since);
  void setShare(double share);
  void end();
  /// Since the work began.
  double elapsedSeconds() const { return static_cast<double>(clock_.elapsed()) / 1000.0; }

 private:
  void showElapsed();

  QLabel* what_;
  QProgressBar* progress_;
  QLabel* seconds_;
  QTimer patience_;
  QTimer tick_;
  QElapsedTimer clock_;
};

}  // namespace glissade
