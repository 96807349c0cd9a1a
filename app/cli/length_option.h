#pragma once

#include <string>

namespace glissade::cli {

/// Metres of a length as people write it: 0.0005, 0.5mm, 5 cm, 1in. Units: m, cm, mm, in, inch, ft; none: metres.
/// Throws CLI::ValidationError with what is wrong.
double metres(const std::string& text);

}  // namespace glissade::cli
