#pragma once

#include <string>

namespace glissade {

/// The text escaped for XML and HTML, in elements and between double quotes. Characters that XML forbids are left out.
std::string escaped(const std::string& text);

/// A coordinate with at most two decimals, so that the text is the same on all machines.
std::string pixels(double value);

/// The beginning of a picture of this size, in its pixels, with a background of this colour. "</svg>" ends it.
std::string svgBegin(double width, double height, const std::string& ground);

/// A line of text in a picture. `anchor`: "start", "middle" or "end" of the text is at x.
std::string svgText(double x, double y, const std::string& anchor, const std::string& text, const std::string& colour);

}  // namespace glissade
