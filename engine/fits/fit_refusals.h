#pragma once

#include "engine/base/message.h"

namespace glissade {

// Reasons why a pair of bodies counts as a clash, for people; lengths in metres.

/// Neither body has room for the allowance.
Message noRoom(double allowance);
/// Neither body has room, and the surface of one is open at this distance from the contact.
Message noRoomBeside(double allowance, double opening);
/// The surfaces of both bodies are open at these distances from the contact.
Message openOnBothSides(double opening, double othersOpening);

}  // namespace glissade
