#include "engine/session/start_tree_distance.h"

#include <limits>

namespace glissade {

void StartTreeDistance::update(const std::vector<RoadmapNode>& nodes) {
  while (nodesSeen_ < nodes.size()) take(nodes[nodesSeen_]);
}

void StartTreeDistance::update(const RoadmapChunks& chunks) {
  for (; chunksSeen_ < chunks.size(); ++chunksSeen_) {
    for (const RoadmapNode& node : chunks[chunksSeen_]->nodes) take(node);
  }
}

double StartTreeDistance::operator()(const Pose& q) const {
  const auto nearest = tree_.nearest(q);
  return nearest ? nearest->distance : std::numeric_limits<double>::infinity();
}

void StartTreeDistance::take(const RoadmapNode& node) {
  if (node.side == TreeSide::Start) tree_.add(static_cast<std::uint32_t>(nodesSeen_), node.q);
  if (node.author == Author::Contact) ++contactNodes_;
  ++nodesSeen_;
}

}  // namespace glissade
