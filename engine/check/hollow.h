#pragma once

#include <optional>

#include "engine/base/stop_token.h"
#include "engine/check/placed_body.h"

namespace glissade::check {

/// What is left of a body where what another one, the guest, fills is taken away: a clash that a person accepts.
struct Hollow {
  TriangleMesh mesh;  ///< in the frame in which both bodies were given
  /// Metres, to a hundredth: how deep the surface of the one is in the other one, in the body where that is less.
  double depth = 0.0;
};

/// The surface of the body that is outside of the guest, and the surface of the guest that is inside of the body,
/// turned round. Triangles are cut where they meet the other surface. What is left meets the guest at the cut: it has
/// to be taken thinner by hollowRoom() to be free. Pieces within ten nanometres of the guest's surface stay.
///
/// Nothing where the surface of one of them is not closed, where they do not overlap, where nothing is left, where the
/// pieces are too many, or after a stop.
std::optional<Hollow> hollowed(const PlacedBody& body, const PlacedBody& guest, const StopToken& stop = {});

/// By which the guest is taken thinner at all of its faces, metres: the margin and the spacing of the coordinates.
double hollowRoom(const PlacedBody& one, const PlacedBody& other);

}  // namespace glissade::check
