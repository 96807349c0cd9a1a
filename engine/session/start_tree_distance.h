#pragma once

#include "engine/planning/nearest_neighbours.h"
#include "engine/planning/roadmap.h"

namespace glissade {

/// Distance of the start tree from a configuration, which an operator sees on the screen and waits for.
class StartTreeDistance {
 public:
  explicit StartTreeDistance(const Se3Metric& metric) : metric_(metric), tree_(metric) {}

  /// Adds new nodes. Call it with a longer list each time, or after reset().
  void update(const std::vector<RoadmapNode>& nodes);
  void update(const RoadmapChunks& chunks);
  void reset() { *this = StartTreeDistance(metric_); }

  /// Metric distance from q to the nearest node of the start tree; infinite while there is none.
  double operator()(const Pose& q) const;
  /// Number of nodes of either tree that contact sampling has added.
  std::uint64_t contactNodes() const { return contactNodes_; }

 private:
  void take(const RoadmapNode& node);

  Se3Metric metric_;
  NearestNeighbours tree_;
  std::uint64_t contactNodes_ = 0;
  std::size_t nodesSeen_ = 0;
  std::size_t chunksSeen_ = 0;
};

}  // namespace glissade
