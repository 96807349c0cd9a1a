#include "widgets/scene3d/detail_control.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace glissade {
namespace {

/// A step of coarseness, and the duration of a picture above which the next picture takes the next step.
struct Step {
  PictureDetail detail;
  double longest;
};

/// The first steps have fewer triangles, which are hardly visible. Fewer pixels are visible; these steps come at longer
/// durations, which software drawing has.
constexpr std::array kSteps{Step{{1.0, 1.0, true}, 0.05},  Step{{2.0, 1.0, true}, 0.05}, Step{{4.0, 1.0, true}, 0.05},
                            Step{{8.0, 1.0, true}, 0.1},   Step{{8.0, 1.0, false}, 0.1}, Step{{8.0, 0.7, false}, 0.1},
                            Step{{10.0, 0.5, false}, 1e30}};
constexpr int kLastStep = static_cast<int>(kSteps.size()) - 1;
/// The coarsest step with all pixels, which pictures at rest never exceed.
constexpr int kCoarsestAtRest = 3;

constexpr const Step& stepAt(int step) { return kSteps[static_cast<std::size_t>(step)]; }

}  // namespace

PictureDetail DetailControl::begin(bool refines) {
  const bool changedBefore = changes_;
  changes_ = !refines;
  // Detail never becomes finer within a motion, because it would alternate from picture to picture.
  if (changes_ && !changedBefore) changed_ = std::max(0, changed_ - 1);
  drawn_ = changes_ ? changed_ : std::clamp(drawn_ - 1, 0, kCoarsestAtRest);
  return stepAt(drawn_).detail;
}

bool DetailControl::end(double seconds) {
  // Each step halves the duration of a picture, about.
  for (double rest = seconds; changes_ && changed_ < kLastStep && rest > stepAt(changed_).longest; rest *= 0.5) {
    ++changed_;
  }
  return drawn_ > 0;
}

}  // namespace glissade
