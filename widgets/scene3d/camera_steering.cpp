#include "widgets/scene3d/camera_steering.h"

#include <cmath>
#include <numbers>

#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

/// Speeds at full deflection, for each second: heights of the view, natural logarithms of the zoom, half turns.
constexpr double kHeights = 0.6;
constexpr double kZooms = 1.0;
constexpr double kHalfTurns = 0.4;

}  // namespace

void steerCamera(CameraController& camera, const Deflection& deflection, const OperatorSpeed& factors, double dt,
                 bool roll) {
  const Vector3 shift = dt * factors.linear * deflection.translation;
  const Vector3 turn = dt * factors.angular * deflection.rotation;
  camera.pan(kHeights * shift.x(), -kHeights * shift.y());
  camera.zoom(std::exp(kZooms * shift.z()));
  camera.orbit(kHalfTurns * turn.y(), kHalfTurns * turn.x());
  if (roll) camera.roll(-kHalfTurns * std::numbers::pi * turn.z());
}

}  // namespace glissade
