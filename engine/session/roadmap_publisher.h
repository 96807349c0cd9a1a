#pragma once

#include "engine/planning/planner.h"

namespace glissade {

/// Turns a planner's growing roadmap into immutable chunks: what was published is shared, never
/// copied again.
class RoadmapPublisher {
 public:
  /// Publishes what came since the last call.
  void update(const Planner& planner);
  void reset();

  const RoadmapChunks& chunks() const { return chunks_; }
  const std::vector<RoadmapEdge>& droppedEdges() const { return dropped_; }
  const PerAuthor<std::uint64_t>& nodesByAuthor() const { return nodesByAuthor_; }

 private:
  RoadmapChunks chunks_;
  std::vector<RoadmapEdge> dropped_;
  PerAuthor<std::uint64_t> nodesByAuthor_{};
  std::size_t nodes_ = 0;
  std::size_t edges_ = 0;
};

}  // namespace glissade
