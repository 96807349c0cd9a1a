#pragma once

#include <string>

#include "engine/base/message.h"
#include "engine/fits/allowance.h"

namespace glissade {

// Reasons why a pair of bodies counts as a clash, for people; lengths in metres.

/// Neither body has room for the allowance.
Message noRoom(double allowance);
/// Neither body has room, and the surface of one is open at this distance from the contact.
Message noRoomBeside(double allowance, double opening);
/// The surfaces of both bodies are open at these distances from the contact.
Message openOnBothSides(double opening, double othersOpening);

/// True if the allowance is by a clash that a person accepts: a body is cut, or is thinned by more than a fit is deep.
bool isByAcceptedClash(const Allowance& allowance);

/// How an accepted clash is taken, and the body to name if that is not what was meant. `own`, `other`: names of the
/// moving body and of the body in `clash`.
Message adviceToCut(const Allowance& clash, const std::string& own, const std::string& other);

}  // namespace glissade
