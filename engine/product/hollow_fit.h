#pragma once

#include <optional>

#include "engine/check/placed_bodies.h"
#include "engine/product/thinnable_bodies.h"

namespace glissade {

/// A pair of which one body, the host, is taken without what the other one, the guest, fills.
struct HollowFit {
  MeshPtr host;          ///< in its frame
  MeshPtr guest;         ///< taken thinner all around, in its frame
  double room;           ///< by which the guest is taken thinner, metres
  double spacing;        ///< of the coordinates of both, metres: a part of the room
  double surface = 0.0;  ///< check::wallDeflection(), metres: likewise
};

/// Nothing where the overlap cannot be taken away (check::hollowed()), or where the guest has no place for the room.
std::optional<HollowFit> hollowFitOf(const check::Placement& host, const check::Placement& guest,
                                     check::PlacedBodies& placed, ThinnableBodies& thinnable, const StopToken& stop);

}  // namespace glissade
