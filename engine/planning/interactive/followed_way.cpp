#include "engine/planning/interactive/followed_way.h"

#include <algorithm>

namespace glissade {

bool FollowedWay::add(const Pose& q, const NearestObstacle& nearest, double moved) {
  const std::uint64_t before = recorder_.version();
  recorder_.add(q, nearest, moved);
  reached_ = std::max(reached_, first());
  return recorder_.version() != before;
}

void FollowedWay::follow(const RoadmapGraph& roadmap, RoadmapGraph::ComponentId tree) {
  const auto& points = recorder_.points();
  for (; nodesSeen_ < roadmap.nodes().size(); ++nodesSeen_) {
    if (roadmap.componentOf(static_cast<RoadmapGraph::Node>(nodesSeen_)) != tree) continue;
    const Pose& q = roadmap.nodes()[nodesSeen_].q;
    for (std::uint64_t i = recorder_.version(); i > reached_; --i) {
      if (same(points[i - 1 - first()].q, q)) reached_ = i;
    }
  }
}

std::vector<Pose> FollowedWay::missing() const {
  std::vector<Pose> missing;
  for (std::uint64_t i = reached_; i < recorder_.version(); ++i) {
    const ShownWay::Point& point = recorder_.points()[i - first()];
    if (point.nearest.distance > 0.0) missing.push_back(point.q);
  }
  return missing;
}

const Pose& FollowedWay::anyMissing(RandomStream& stream) const {
  const std::uint64_t missing = recorder_.version() - reached_;
  const auto i = static_cast<std::uint64_t>(stream.uniform() * static_cast<double>(missing));
  return recorder_.points()[reached_ + std::min(i, missing - 1) - first()].q;
}

}  // namespace glissade
