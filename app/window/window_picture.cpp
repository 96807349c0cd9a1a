#include "app/window/window_picture.h"

#include <QCoreApplication>
#include <QDialog>
#include <QPainter>

namespace glissade {

QImage pictureOf(QMainWindow& window) {
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);  // lays the panels out before the picture
  QPixmap whole = window.grab();
  QPainter painter(&whole);
  for (QDialog* dialog : window.findChildren<QDialog*>()) {
    if (dialog->isVisible()) {
      painter.drawPixmap(dialog->geometry().topLeft() - window.geometry().topLeft(), dialog->grab());
    }
  }
  return whole.toImage();
}

}  // namespace glissade
