#pragma once

#include <optional>

#include "engine/base/stop_token.h"
#include "engine/evidence/placed_body.h"

namespace glissade::evidence {

/// A body without the volume that another body, the guest, fills: the remainder of an accepted clash. The mesh is in
/// the frame of the given bodies.
///
/// Its surface is the part of the body's surface outside of the guest, and the part of the guest's surface inside of
/// the body, reversed (surface_cut.h). The remainder meets the guest at the cut: the guest is free if it is thinned by
/// hollowRoom(). Pieces within ten nanometres of the guest's surface are kept.
///
/// Nothing if one of the surfaces is not closed, if the bodies do not overlap, if nothing remains, if there are too
/// many pieces, or after a stop.
std::optional<TriangleMesh> hollowed(const PlacedBody& body, const PlacedBody& guest, const StopToken& stop = {});

/// Deviation of the guest's surface, and of the wall cut with it, from the guest's true surface, metres.
double wallDeflection(const PlacedBody& guest);

/// Allowance of the guest at all of its faces, metres: the deflection of the wall, so that a round guest can turn in
/// it, the margin, and the spacing of the coordinates.
double hollowRoom(const PlacedBody& body, const PlacedBody& guest);

}  // namespace glissade::evidence
