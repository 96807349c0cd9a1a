#pragma once

#include <optional>

#include "engine/evidence/placed_bodies.h"
#include "engine/fits/thinnable_bodies.h"

namespace glissade {

/// A pair in which one body, the host, is taken without the volume that the other body, the guest, fills.
struct HollowFit {
  MeshPtr host;          ///< host in its frame
  MeshPtr guest;         ///< guest, thinned all around, in its frame
  double room;           ///< allowance of the guest, metres
  double spacing;        ///< spacing of the coordinates of both, metres: a part of the room
  double surface = 0.0;  ///< evidence::wallDeflection(), metres: a part of the room
};

/// Nothing if the overlap cannot be taken away (evidence::hollowed()), or if the guest has no room for the allowance.
std::optional<HollowFit> hollowFitOf(const evidence::Placement& host, const evidence::Placement& guest,
                                     evidence::PlacedBodies& placed, ThinnableBodies& thinnable, const StopToken& stop);

}  // namespace glissade
