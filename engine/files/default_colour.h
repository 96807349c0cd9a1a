#pragma once

#include <string>

#include "engine/places/rigid_body.h"

namespace glissade {

/// The colour of a static body whose file has none. It is of low saturation and depends on the name only, so that it
/// stays when other bodies come and go. Bodies whose names differ only in a number at the end have the same colour:
/// pump-1 and pump-2, nut and nut#2.
Colour defaultColour(const std::string& bodyName);

}  // namespace glissade
