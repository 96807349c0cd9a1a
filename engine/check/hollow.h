#pragma once

#include <optional>

#include "engine/base/stop_token.h"
#include "engine/check/placed_body.h"

namespace glissade::check {

/// A body without what another one, the guest, fills: the remainder of a clash that a person accepts. In the
/// frame in which both bodies were given.
///
/// The surface of the body that is outside of the guest, and the surface of the guest that is inside of the body,
/// turned round (surface_cut.h). What is left meets the guest at the cut: the guest has to be taken thinner by
/// hollowRoom() to be free. Pieces within ten nanometres of the guest's surface stay.
///
/// Nothing where the surface of one of them is not closed, where they do not overlap, where nothing is left, where the
/// pieces are too many, or after a stop.
std::optional<TriangleMesh> hollowed(const PlacedBody& body, const PlacedBody& guest, const StopToken& stop = {});

/// By which the surface of the guest, and the wall of the cut that is made of it, are off the guest's true surface,
/// metres.
double wallDeflection(const PlacedBody& guest);

/// By which the guest is taken thinner at all of its faces, metres: the deflection of the wall, so that a round guest
/// turns in it, the margin, and the spacing of the coordinates.
double hollowRoom(const PlacedBody& body, const PlacedBody& guest);

}  // namespace glissade::check
