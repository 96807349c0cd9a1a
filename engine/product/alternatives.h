#pragma once

#include <vector>

#include "engine/base/diagnostic.h"
#include "engine/base/stop_token.h"
#include "engine/product/contact_report.h"

namespace glissade {

/// Two bodies that fill the same place: variants of one part that the file has both of.
struct Alternative {
  std::size_t a = 0;  ///< index of the body
  std::size_t b = 0;
  double share = 0.0;  ///< of the volume of the larger one that both fill, estimated
};

/// Pairs of closed bodies, among those that overlap, that have at least half of the larger one in common. A screw in a
/// block that has no hole for it is none: the block is not filled by it.
std::vector<Alternative> findAlternatives(const std::vector<RigidBody>& bodies, const std::vector<Contact>& contacts,
                                          const StopToken& stop = {});

/// One for each, with the option that leaves one of the two out.
Warnings warningsOf(const std::vector<Alternative>& alternatives, const std::vector<RigidBody>& bodies);

}  // namespace glissade
