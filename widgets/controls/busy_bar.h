#pragma once

#include <QAction>
#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <QWidget>

namespace glissade {

/// The work in the background, its duration and progress, and a button that ends it. Work that is done at once does not
/// make the bar flash.
class BusyBar final : public QWidget {
  Q_OBJECT

 public:
  BusyBar(QAction* cancel, QWidget* parent);

  void begin(const QString& what, const QElapsedTimer& since);
  void setShare(double share);
  void end();
  /// Seconds since the work began.
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
