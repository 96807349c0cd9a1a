#include "widgets/workbench/drag_tool.h"

#include <QMouseEvent>

#include <algorithm>

namespace glissade {

DragTool::DragTool(SceneWidget& scene, QObject* parent) : QObject(parent), scene_(scene) {
  scene_.widget()->installEventFilter(this);
  scene_.widget()->setMouseTracking(true);
}

bool DragTool::eventFilter(QObject* watched, QEvent* event) {
  const bool mouse = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseMove ||
                     event->type() == QEvent::MouseButtonRelease;
  if (!mouse) return QObject::eventFilter(watched, event);
  const auto& pointer = static_cast<const QMouseEvent&>(*event);
  if (event->type() == QEvent::MouseButtonPress) {
    last_ = pointer.localPos();
    return pointer.button() == Qt::LeftButton && !pointer.modifiers().testFlag(Qt::ShiftModifier) && grip(last_);
  }
  if (!holds()) return QObject::eventFilter(watched, event);
  if (event->type() == QEvent::MouseMove) {
    follow(pointer.localPos(), pointer.modifiers().testFlag(Qt::ControlModifier));
  } else if (pointer.button() == Qt::LeftButton) {
    drop();
  }
  return true;
}

void DragTool::follow(const QPointF& position, bool turning) {
  if (turning) {
    turn(position, (position - last_) / std::max(1, scene_.widget()->height()));
  } else {
    moveTo(position);
  }
  last_ = position;
}

}  // namespace glissade
