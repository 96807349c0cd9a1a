#pragma once

#include <string>

namespace glissade {

/// A text as XML and HTML hold it, in elements and between double quotes. Characters that XML forbids
/// are left out.
std::string escaped(const std::string& text);

/// Two decimals at most: enough for a picture, and the same text everywhere.
std::string pixels(double value);

/// The beginning of a picture of this size, in its pixels, with a ground of this colour. "</svg>" ends it.
std::string svgBegin(double width, double height, const std::string& ground);

/// A line of text in a picture. `anchor`: "start", "middle" or "end" of the text is at x.
std::string svgText(double x, double y, const std::string& anchor, const std::string& text, const std::string& colour);

}  // namespace glissade
