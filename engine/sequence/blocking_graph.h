#pragma once

#include <functional>
#include <vector>

#include "engine/sequence/body_group.h"

namespace glissade {

/// Who blocks whom along one direction: a directional blocking graph (Wilson and Latombe 1994).
class BlockingGraph {
 public:
  explicit BlockingGraph(std::size_t bodies) : blockers_(bodies), stays_(bodies, false) {}

  void blocks(std::size_t blocker, std::size_t blocked) { blockers_[blocked].push_back(blocker); }
  /// The body does not leave, whoever else does.
  void stays(std::size_t body) { stays_[body] = true; }

  /// Groups of at least two units that nobody else blocks, one for each unit in the smallest of them that holds it;
  /// none of more than `most` bodies. `units`: all bodies that are there, those that only leave together in one.
  std::vector<BodyGroup> groups(const std::vector<BodyGroup>& units, std::size_t most) const;

 private:
  BodyGroup smallestWith(std::size_t unit, const std::vector<BodyGroup>& units, const std::vector<std::size_t>& unitOf,
                         std::size_t most) const;

  std::vector<std::vector<std::size_t>> blockers_;  ///< of each body
  std::vector<bool> stays_;
};

/// Of these groups the smallest, and of those that have no body in common with one of them the smallest, and so on; of
/// equally many bodies, the one of less volume first, then by the bodies.
std::vector<BodyGroup> smallestDisjoint(std::vector<BodyGroup> groups,
                                        const std::function<double(const BodyGroup&)>& volume);

}  // namespace glissade
