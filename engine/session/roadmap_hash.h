#pragma once

#include <cstdint>

#include "engine/planning/planner.h"

namespace glissade {

/// A 64-bit fingerprint of a growing roadmap: every bit of every node, edge and dropped edge counts,
/// and their order, but not how often it was updated.
class RoadmapHash {
 public:
  /// Takes in what is new.
  void update(const Planner& planner);
  std::uint64_t value() const;

 private:
  struct Stream {
    std::uint64_t hash = 0xcbf29ce484222325U;
    std::size_t taken = 0;
    void add(std::uint64_t word);
  };
  void add(const RoadmapNode& node);

  Stream nodes_;
  Stream edges_;
  Stream dropped_;
};

}  // namespace glissade
