#include "engine/import/formats/mesh_content.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade {

double floatSpacing(double magnitude) {
  const float at = static_cast<float>(std::abs(magnitude));
  return static_cast<double>(std::nextafter(at, std::numeric_limits<float>::infinity())) - static_cast<double>(at);
}

std::string inQuotes(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text(word.substr(0, kLongest));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + text + (word.size() > kLongest ? "..." : "") + "'";
}

}  // namespace glissade
