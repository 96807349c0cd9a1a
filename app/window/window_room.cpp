#include "app/window/window_room.h"

#include <QEvent>
#include <QLayout>
#include <QMainWindow>
#include <QTimer>

#include "widgets/workbench/panel_docks.h"

namespace glissade {

WindowRoom::WindowRoom(QMainWindow& window, PanelDocks& docks) : window_(window), docks_(docks) {
  window.installEventFilter(this);
}

void WindowRoom::fit(const QSize& room) {
  room_ = room;
  if (room.isEmpty()) return;
  docks_.setRoom(room);
  window_.layout()->activate();  // the least size is that of what is shown now
  window_.resize(window_.size().boundedTo(room));
}

bool WindowRoom::eventFilter(QObject* watched, QEvent* event) {
  if (room_.isEmpty()) return false;
  if (event->type() == QEvent::FontChange) {
    docks_.setRoom(room_);  // larger texts need more room
  } else if (event->type() == QEvent::Resize && !event->spontaneous() &&
             window_.size() != window_.size().boundedTo(room_)) {
    QTimer::singleShot(0, this, [this] { fit(room_); });
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace glissade
