#pragma once

#include <string>

namespace glissade {

/// "12.345 mm": in whole micrometres. The depth of an overlap, which a person accepts as it is stated.
std::string depthInMillimetres(double metres);

/// "12.345mm": the same as options of the command line take it.
std::string depthAsOption(double metres);

}  // namespace glissade
