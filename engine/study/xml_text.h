#pragma once

#include <string>

namespace glissade {

/// A text as XML and HTML hold it, in elements and between double quotes. Characters that XML forbids
/// are left out.
std::string escaped(const std::string& text);

/// Two decimals at most: enough for a picture, and the same text everywhere.
std::string pixels(double value);

}  // namespace glissade
