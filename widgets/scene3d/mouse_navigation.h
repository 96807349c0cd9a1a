#pragma once

#include <QMouseEvent>
#include <QPointF>
#include <QWheelEvent>
#include <QWidget>

#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// What the mouse does in a scene widget: left drag orbits, middle drag (or Shift + left) pans, right
/// drag and wheel zoom, double click fits. Each returns whether the camera has moved.
class MouseNavigation {
 public:
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event, const QWidget& widget, SceneView& view);
  bool doubleClick(SceneView& view);
  bool wheel(const QWheelEvent& event, const QWidget& widget, SceneView& view);

 private:
  QPointF last_;
};

}  // namespace glissade
