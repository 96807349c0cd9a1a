#pragma once

#include <QWidget>

namespace glissade {

/// Makes a dialog, or another window beside the main one, no larger than `room`: its content is scrolled where it needs
/// more, and its buttons stay below it. The buttons of a message are put below each other where they have no room side
/// by side, and its texts are scrolled where they need more height.
void fitWindow(QWidget& window, const QSize& room);

/// The size that a window may have on its screen.
QSize roomOn(const QWidget& window);

/// Fits every dialog and window but the main one to its screen when it is shown. Installed on the application.
class ScreenFit final : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace glissade
