#include "engine/session/roadmap_publisher.h"

namespace glissade {

void RoadmapPublisher::update(const Planner& planner) {
  const auto& nodes = planner.nodes();
  const auto& edges = planner.edges();
  if (nodes.size() > nodes_ || edges.size() > edges_) {
    auto chunk = std::make_shared<RoadmapChunk>();
    chunk->nodes.assign(nodes.begin() + static_cast<std::ptrdiff_t>(nodes_), nodes.end());
    chunk->edges.assign(edges.begin() + static_cast<std::ptrdiff_t>(edges_), edges.end());
    chunks_.push_back(chunk);  // may throw: the counters change afterwards
    for (const RoadmapNode& node : chunk->nodes) ++nodesByAuthor_[static_cast<std::size_t>(node.author)];
    nodes_ = nodes.size();
    edges_ = edges.size();
  }
  for (std::size_t i = dropped_.size(); i < planner.droppedEdges().size(); ++i) {
    dropped_.push_back(edges[planner.droppedEdges()[i]]);
  }
}

void RoadmapPublisher::reset() { *this = RoadmapPublisher(); }

}  // namespace glissade
