#include "engine/planning/random_shooter.h"

#include <cmath>
#include <numbers>

namespace glissade {

Pose RandomShooter::shoot() {
  if (source_) {
    if (!draw_) draw_ = source_(seed_);
    return draw_();
  }
  Pose q;
  if (region_) {
    q.position = region_->sample(stream_, bounds_);
  } else {
    for (int axis = 0; axis < 3; ++axis) q.position[axis] = stream_.uniform(bounds_.min()[axis], bounds_.max()[axis]);
  }
  q.orientation = orientation(stream_);
  return q;
}

Quaternion RandomShooter::orientation(RandomStream& stream) {
  const double u1 = stream.uniform();
  const double u2 = 2.0 * std::numbers::pi * stream.uniform();
  const double u3 = 2.0 * std::numbers::pi * stream.uniform();
  const double a = std::sqrt(1.0 - u1);
  const double b = std::sqrt(u1);
  return Quaternion(b * std::cos(u3), a * std::sin(u2), a * std::cos(u2), b * std::sin(u3)).normalized();
}

}  // namespace glissade
