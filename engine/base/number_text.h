#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace glissade {

/// The shortest decimal text that reads back as exactly this number, whatever the locale.
std::string toText(double value);

/// The number that the whole text is, whatever the locale; nothing where it is none or not finite.
std::optional<double> toNumber(std::string_view text);

}  // namespace glissade
