#include "widgets/scene3d/mouse_navigation.h"

#include <cmath>

#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

/// Factor by which one notch of a wheel (120 eighths of a degree) comes nearer.
constexpr double kPerNotch = 1.15;
/// Factor by which a drag over the view's height zooms.
constexpr double kPerHeight = 8.0;
/// Angle in radians by which a drag to the side by the view's height rolls.
constexpr double kRollPerHeight = 3.0;

}  // namespace

bool MouseNavigation::press(const QMouseEvent& event) {
  last_ = event.localPos();
  return false;
}

bool MouseNavigation::move(const QMouseEvent& event, const QWidget& widget, SceneView& view) {
  const QPointF by = (event.localPos() - last_) / std::max(1, widget.height());
  last_ = event.localPos();
  CameraController& camera = view.camera();
  switch (cameraDragOf(style_, event.buttons(), event.modifiers())) {
    case CameraDrag::None: return false;
    case CameraDrag::Orbit: camera.orbit(by.x(), by.y()); break;
    case CameraDrag::Tumble: camera.tumble(by.x(), by.y()); break;
    case CameraDrag::Roll: camera.roll(-kRollPerHeight * by.x()); break;
    case CameraDrag::Pan: camera.pan(by.x(), by.y()); break;
    case CameraDrag::Zoom: camera.zoom(std::pow(kPerHeight, -by.y())); break;
  }
  return true;
}

bool MouseNavigation::doubleClick(SceneView& view) {
  view.fit();
  return true;
}

bool MouseNavigation::wheel(const QWheelEvent& event, const QWidget& widget, SceneView& view) {
  const double notches = event.angleDelta().y() / 120.0;
  const QPointF fromCentre =
      (event.position() - QPointF(widget.width(), widget.height()) / 2.0) / std::max(1, widget.height());
  view.camera().zoom(std::pow(kPerNotch, notches), fromCentre.x(), fromCentre.y());
  return notches != 0.0;
}

}  // namespace glissade
