#pragma once

#include <string>

namespace glissade {

/// A depth in whole micrometres: "12.345 mm". For the depth of an overlap, which a person accepts as stated.
std::string depthInMillimetres(double metres);

/// The depth as an option of the command line: "12.345mm".
std::string depthAsOption(double metres);

}  // namespace glissade
