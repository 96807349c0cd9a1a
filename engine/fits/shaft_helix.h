#pragma once

#include <optional>

#include "engine/base/message.h"
#include "engine/fits/fastener_shape.h"

namespace glissade {

/// Evidence of a joint, for people.
inline constexpr CatalogueText kModelledHelix = GLISSADE_TEXT("a helix is modelled on it");

/// The pitch of a thread that is modelled on the shaft of a screw, metres a turn; below 0: left-handed. Nothing where
/// the shaft has no helix. Within about a percent; the standard pitch of the diameter where it is that near.
std::optional<double> modelledPitch(const AxialMesh& screw, const TurnedShape& shape);

}  // namespace glissade
