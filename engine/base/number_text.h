#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace glissade {

/// The shortest decimal text that reads back as exactly this number, in any locale.
std::string toText(double value);

/// The number with six significant digits.
std::string shortText(double value);

/// The number that the whole text states, in any locale; nothing where it is none or not finite.
std::optional<double> toNumber(std::string_view text);

}  // namespace glissade
