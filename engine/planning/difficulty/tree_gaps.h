#pragma once

#include <cstdint>
#include <vector>

#include "engine/planning/problem.h"
#include "engine/planning/roadmap.h"

namespace glissade {

/// A roadmap as two trees. An end from which no planner grew a tree is added as a node after those of the planners.
struct GrownTrees {
  std::vector<RoadmapNode> nodes;
  std::vector<std::vector<std::uint32_t>> links;  ///< neighbours of each node
};
GrownTrees grownTrees(const Problem& problem, const std::vector<RoadmapNode>& nodes,
                      const std::vector<RoadmapEdge>& edges, CollisionQuery& query);

/// A node of the start's tree and the node of the goal's tree that is nearest to it.
struct TreeGap {
  std::uint32_t start = 0;
  std::uint32_t goal = 0;
  double distance = 0.0;  ///< distance in the metric, metres
};

/// At most `most` gaps, by distance: first the nearest two nodes of both trees. A further gap begins at least `apart`
/// (metres in the metric) from the beginnings of the gaps before it. Empty where a tree is missing; fewer after a stop.
std::vector<TreeGap> treeGaps(const GrownTrees& trees, const Se3Metric& metric, double apart, std::size_t most,
                              const StopToken& stop);

}  // namespace glissade
