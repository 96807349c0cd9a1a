#pragma once

#include <vector>

#include "engine/base/diagnostic.h"
#include "engine/base/stop_token.h"
#include "engine/places/rigid_body.h"

namespace glissade {

/// Two bodies that fill the same space: variants of one part that are both in the file.
struct Alternative {
  std::size_t a = 0;  ///< index of the body
  std::size_t b = 0;
  double share = 0.0;  ///< estimated share of the larger body's volume that both fill
};

/// Pairs of closed bodies that share at least half of the larger one, by a, then by b. A screw in a block without a
/// hole for it is not such a pair, because it does not fill the block.
std::vector<Alternative> findAlternatives(const std::vector<RigidBody>& bodies, const StopToken& stop = {});

/// Groups of bodies that are alternatives of each other, directly or through others, by ascending index. A product has
/// one body of each group.
std::vector<std::vector<std::size_t>> variantsOf(const std::vector<Alternative>& alternatives);

/// A warning for each pair, with the option that leaves one of the two out.
Warnings warningsOf(const std::vector<Alternative>& alternatives, const std::vector<RigidBody>& bodies);

}  // namespace glissade
