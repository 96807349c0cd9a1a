#pragma once

#include <array>
#include <charconv>
#include <string>

namespace glissade {

/// The text of a vertex number in a file. It may be any number: it need not fit an integer.
inline std::string indexText(double index) {
  std::array<char, 32> text;
  const auto written = std::to_chars(text.data(), text.data() + text.size(), index);
  return {text.data(), written.ptr};
}

}  // namespace glissade
