#pragma once

#include <functional>
#include <vector>

#include "engine/sequence/body_group.h"

namespace glissade {

/// Who blocks whom along one direction: a directional blocking graph (Wilson and Latombe 1994). Its edges are asked for
/// where a group depends on them, because an edge may be an exact motion of one body past another one.
class BlockingGraph {
 public:
  /// What the graph asks of two bodies. The answers do not change.
  struct Edges {
    /// Bodies that may block this one, the likely ones first.
    std::function<const std::vector<std::size_t>&(std::size_t blocked)> candidates;
    std::function<bool(std::size_t blocker, std::size_t blocked)> blocks;
  };

  /// `staying`: bodies that do not leave, whoever else does.
  BlockingGraph(BodySet staying, Edges edges) : staying_(std::move(staying)), edges_(std::move(edges)) {}

  /// Groups of at least two units that nobody else blocks, one for each unit in the smallest of them that holds it;
  /// none of more than `most` bodies. `units`: all bodies that are there, those that only leave together in one.
  std::vector<BodyGroup> groups(const std::vector<BodyGroup>& units, std::size_t most) const;

 private:
  BodySet staying_;
  Edges edges_;
};

/// Of these groups the smallest, and of those that have no body in common with one of them the smallest, and so on; of
/// equally many bodies, the one of less volume first, then by the bodies.
std::vector<BodyGroup> smallestDisjoint(std::vector<BodyGroup> groups,
                                        const std::function<double(const BodyGroup&)>& volume);

}  // namespace glissade
