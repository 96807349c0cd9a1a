#pragma once

#include <vector>

#include "engine/base/diagnostic.h"
#include "engine/base/stop_token.h"
#include "engine/environment/rigid_body.h"

namespace glissade {

/// Two bodies that fill the same place: variants of one part that the file has both of.
struct Alternative {
  std::size_t a = 0;  ///< index of the body
  std::size_t b = 0;
  double share = 0.0;  ///< of the volume of the larger one that both fill, estimated
};

/// Pairs of closed bodies that have at least half of the larger one in common, by a, then by b. A screw in a block that
/// has no hole for it is none: the block is not filled by it.
std::vector<Alternative> findAlternatives(const std::vector<RigidBody>& bodies, const StopToken& stop = {});

/// Bodies that are alternatives of each other, directly or by others: groups of ascending indices, of which a product
/// has one body each.
std::vector<std::vector<std::size_t>> variantsOf(const std::vector<Alternative>& alternatives);

/// One for each, with the option that leaves one of the two out.
Warnings warningsOf(const std::vector<Alternative>& alternatives, const std::vector<RigidBody>& bodies);

}  // namespace glissade
