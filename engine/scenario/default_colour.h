#pragma once

#include <string>

#include "engine/environment/rigid_body.h"

namespace glissade {

/// The colour of a static body whose file has none: quiet, and by the name, so that it stays when other bodies come and
/// go. Bodies whose names differ in a number at the end alone have the same one: pump-1 and pump-2, nut and nut#2.
Colour defaultColour(const std::string& bodyName);

}  // namespace glissade
