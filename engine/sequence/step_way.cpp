#include "engine/sequence/step_way.h"

#include <algorithm>

#include "engine/geometry/se3_metric.h"

namespace glissade {

StepWay::StepWay(const StepMotion& motion, const RigidBody& firstBody)
    : radius_(std::max(1e-9, 0.5 * boundingBox(*firstBody.mesh).diagonal().norm())) {
  const Se3Metric metric(radius_);
  for (const PathPoint& point : motion.path) {
    arrival_.push_back(way_.empty() ? 0.0 : arrival_.back() + metric.distance(way_.back(), point.q));
    way_.push_back(point.q);
  }
}

Pose StepWay::movedAt(double way) const {
  if (way_.size() < 2) return Pose::identity();
  const auto after = std::upper_bound(arrival_.begin() + 1, arrival_.end() - 1, way);
  const auto i = static_cast<std::size_t>(after - arrival_.begin());
  const double length = arrival_[i] - arrival_[i - 1];
  const Pose q = interpolate(way_[i - 1], way_[i], length > 0.0 ? (way - arrival_[i - 1]) / length : 1.0);
  return q * inverse(way_.front());
}

}  // namespace glissade
