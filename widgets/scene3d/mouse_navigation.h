#pragma once

#include <QMouseEvent>
#include <QPointF>
#include <QWheelEvent>
#include <QWidget>

#include "widgets/scene3d/navigation_style.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// Moves the camera by the mouse: drags as the navigation style defines them, the wheel zooms, a double click fits.
/// Each function returns whether the camera has moved.
class MouseNavigation {
 public:
  void setStyle(NavigationStyle style) { style_ = style; }
  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event, const QWidget& widget, SceneView& view);
  bool doubleClick(SceneView& view);
  bool wheel(const QWheelEvent& event, const QWidget& widget, SceneView& view);

 private:
  NavigationStyle style_ = NavigationStyle::Standard;
  QPointF last_;
};

}  // namespace glissade
