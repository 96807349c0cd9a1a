// Numbers and cells of the tables that the commands print.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace glissade::cli {

/// The number of UTF-8 characters, not of bytes.
std::size_t widthOf(std::string_view text);
/// The text with spaces behind it, or before it, so that it has this width. A wider text is unchanged.
std::string toLeft(const std::string& text, std::size_t width);
std::string toRight(const std::string& text, std::size_t width);

/// A number with at most this many significant digits.
std::string rounded(double value, int digits = 6);
/// A number with this many digits behind the point.
std::string fixedDigits(double value, int digits);

}  // namespace glissade::cli
