#pragma once

#include <QWidget>

namespace glissade {

/// Makes a dialog, or another window beside the main one, no larger than `room`: content without room is scrolled, and
/// the buttons stay below it. If the buttons of a message do not fit side by side, they are put below each other, and
/// its texts are scrolled if they are too high.
void fitWindow(QWidget& window, const QSize& room);

/// The maximum size of a window on its screen.
QSize roomOn(const QWidget& window);

/// Fits every dialog and window except the main one to its screen when it is shown. It is installed on the application.
class ScreenFit final : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace glissade
