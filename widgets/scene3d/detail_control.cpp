#include "widgets/scene3d/detail_control.h"

#include <algorithm>
#include <array>

#include "widgets/scene3d/camera_controller.h"

namespace glissade {
namespace {

/// A step of coarseness, and the seconds from which a picture of a camera that moves takes the next step.
struct Step {
  PictureDetail detail;
  double longest;
};

/// First fewer triangles, which are hardly seen. Fewer pixels are seen, so they wait for pictures that take longer:
/// that is where the processor draws.
constexpr std::array kSteps{Step{{1.0, 1.0, true}, 0.05},  Step{{2.0, 1.0, true}, 0.05}, Step{{4.0, 1.0, true}, 0.05},
                            Step{{8.0, 1.0, true}, 0.1},   Step{{8.0, 1.0, false}, 0.1}, Step{{8.0, 0.7, false}, 0.1},
                            Step{{10.0, 0.5, false}, 1e30}};
constexpr int kLastStep = static_cast<int>(kSteps.size()) - 1;
/// The coarsest step with all pixels: at rest there are no fewer.
constexpr int kCoarsestAtRest = 3;

}  // namespace

PictureDetail DetailControl::begin(const CameraController& camera) {
  const bool wasMoving = moving_;
  moving_ = camera.eye() != eye_ || !camera.R_WV().coeffs().isApprox(R_WV_.coeffs(), 0.0) ||
            camera.viewHeight() != viewHeight_;
  eye_ = camera.eye();
  R_WV_ = camera.R_WV();
  viewHeight_ = camera.viewHeight();
  // Never finer within a motion: it would change from picture to picture.
  if (moving_ && !wasMoving) moved_ = std::max(0, moved_ - 1);
  drawn_ = moving_ ? moved_ : std::clamp(drawn_ - 1, 0, kCoarsestAtRest);
  return kSteps[static_cast<std::size_t>(drawn_)].detail;
}

bool DetailControl::end(double seconds) {
  if (moving_ && seconds > kSteps[static_cast<std::size_t>(drawn_)].longest) moved_ = std::min(kLastStep, moved_ + 1);
  return drawn_ > 0;
}

}  // namespace glissade
