#pragma once

#include <functional>
#include <vector>

#include "engine/sequence/body_group.h"

namespace glissade {

/// A directional blocking graph (Wilson and Latombe 1994): the blocking pairs of bodies along one direction. An edge is
/// computed only where a group depends on it, because it may need an exact motion of one body past another one.
class BlockingGraph {
 public:
  /// Queries for the edges of the graph. The answers do not change.
  struct Edges {
    /// Bodies that may block this one, the likely ones first.
    std::function<const std::vector<std::size_t>&(std::size_t blocked)> candidates;
    std::function<bool(std::size_t blocker, std::size_t blocked)> blocks;
  };

  /// `staying`: bodies that never leave.
  BlockingGraph(BodySet staying, Edges edges) : staying_(std::move(staying)), edges_(std::move(edges)) {}

  /// Groups of two to `most` units that no body outside of the group blocks: for each unit the smallest such group.
  /// `units`: all bodies that are there, as units that only leave together.
  std::vector<BodyGroup> groups(const std::vector<BodyGroup>& units, std::size_t most) const;

 private:
  BodySet staying_;
  Edges edges_;
};

/// Takes the smallest group, then the smallest one without a body in common with the groups taken, and so on. For equal
/// numbers of bodies the smaller volume comes first, then the lower indices.
std::vector<BodyGroup> smallestDisjoint(std::vector<BodyGroup> groups,
                                        const std::function<double(const BodyGroup&)>& volume);

}  // namespace glissade
