#pragma once

#include <string>

namespace glissade {

// Why a pair of bodies counts as a clash, for people; lengths in metres.

/// Neither body has place for the allowance.
std::string noRoom(double allowance);
/// The same, and the surface of one is open so near to the contact.
std::string noRoomBeside(double allowance, double opening);
/// The surfaces of both are open so near to the contact.
std::string openOnBothSides(double opening, double othersOpening);

}  // namespace glissade
