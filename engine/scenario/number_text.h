#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace glissade {

/// The shortest text that reads back as the same double; the same in every locale.
std::string toText(double value);
/// All of the text as a finite number, whatever the locale.
std::optional<double> toNumber(std::string_view text);

}  // namespace glissade
