#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace glissade {

/// A length in metres from text: 0.5mm, 25.4 mm, 1 in, 0.5". Units: m, cm, mm, µm or um, in, inch or ", ft or '. A
/// number without a unit counts in `unit` metres. Nothing where the text is no length.
std::optional<double> toMetres(std::string_view text, double unit);

/// An angle in radians from text: 30 deg, 30°, 0.1 rad. A number without a unit counts in `unit` radians. Nothing where
/// the text is no angle.
std::optional<double> toRadians(std::string_view text, double unit);

/// A length with three significant digits without zeros at the end: "0.41 mm". The engine's sentences, and the command
/// line's output of plans and fits, use this function; proved clearances of a path are written in full.
std::string inMillimetres(double metres);

}  // namespace glissade
