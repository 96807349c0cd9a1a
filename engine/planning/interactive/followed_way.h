#pragma once

#include "engine/planning/interactive/shown_way.h"
#include "engine/planning/roadmap_graph.h"

namespace glissade {

/// The path that a hand has shown, and the part of it that the start's tree has reached.
class FollowedWay {
 public:
  /// Nearer to it, in radii of the object, a configuration is the same as another.
  static constexpr double kSame = 0.05;

  explicit FollowedWay(const Se3Metric& metric) : metric_(metric), recorder_(metric) {}

  const WayRecorder& recorder() const { return recorder_; }
  /// Adds a point as WayRecorder::add(). Returns true if it is a new point.
  bool add(const Pose& q, const NearestObstacle& nearest, double moved);

  /// Goes on along the way as far as this component has got by the nodes since the last time.
  void follow(const RoadmapGraph& roadmap, RoadmapGraph::ComponentId tree);
  void reachedAll() { reached_ = recorder_.version(); }
  /// The tree has not reached the last point.
  bool isBehind() const { return reached_ < recorder_.version(); }
  /// Free points that it has not reached, in their order.
  std::vector<Pose> missing() const;
  /// A point that it has not reached, free or not. Precondition: isBehind().
  const Pose& anyMissing(RandomStream& stream) const;
  bool same(const Pose& a, const Pose& b) const { return metric_.distance(a, b) <= kSame * metric_.radius(); }

 private:
  std::uint64_t first() const { return recorder_.version() - recorder_.size(); }

  Se3Metric metric_;
  WayRecorder recorder_;
  std::uint64_t reached_ = 0;  ///< points up to the last one that was reached, forgotten ones with them
  std::size_t nodesSeen_ = 0;  ///< by follow()
};

}  // namespace glissade
