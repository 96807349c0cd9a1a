#include "widgets/scene3d/detail_control.h"

#include <algorithm>

#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

/// Pixels. Of a picture at rest, and of one in motion at most.
constexpr double kAtRest = 1.0;
constexpr double kMostInMotion = 8.0;
/// A picture in motion should take less: 20 a second.
constexpr double kLongest = 0.05;

}  // namespace

double DetailControl::begin(const CameraController& camera) {
  const bool wasMoving = moving_;
  moving_ = camera.eye() != eye_ || !camera.R_WV().coeffs().isApprox(R_WV_.coeffs(), 0.0) ||
            camera.viewHeight() != viewHeight_;
  eye_ = camera.eye();
  R_WV_ = camera.R_WV();
  viewHeight_ = camera.viewHeight();
  // Never finer within a motion: it would change from picture to picture.
  if (moving_ && !wasMoving) moved_ = std::max(kAtRest, 0.5 * moved_);
  drawn_ = moving_ ? moved_ : std::max(kAtRest, 0.5 * drawn_);
  return drawn_;
}

bool DetailControl::end(double seconds) {
  if (moving_ && seconds > kLongest) moved_ = std::min(kMostInMotion, 2.0 * moved_);
  return drawn_ > kAtRest;
}

}  // namespace glissade
