#include "widgets/scene3d/detail_control.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace glissade {
namespace {

/// A step of coarseness, and the seconds of a picture from which the next one takes the next step.
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

constexpr const Step& stepAt(int step) { return kSteps[static_cast<std::size_t>(step)]; }

}  // namespace

PictureDetail DetailControl::begin(bool refines) {
  const bool changedBefore = changes_;
  changes_ = !refines;
  // Never finer within a motion: it would change from picture to picture.
  if (changes_ && !changedBefore) changed_ = std::max(0, changed_ - 1);
  drawn_ = changes_ ? changed_ : std::clamp(drawn_ - 1, 0, kCoarsestAtRest);
  return stepAt(drawn_).detail;
}

bool DetailControl::end(double seconds) {
  // Each step takes about half of the time of the one before.
  for (double rest = seconds; changes_ && changed_ < kLastStep && rest > stepAt(changed_).longest; rest *= 0.5) {
    ++changed_;
  }
  return drawn_ > 0;
}

}  // namespace glissade
