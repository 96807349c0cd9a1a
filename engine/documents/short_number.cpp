#include "engine/documents/short_number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace glissade {
namespace {

std::string fixed(double value, int digits) {
  std::array<char, 400> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, digits);
  return {buffer.data(), end.ptr};
}

void dropTrailingZeros(std::string& text) {
  if (text.find('.') == std::string::npos) return;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
}

/// Inserts a narrow no-break space before every third digit from the right.
void separateThousands(std::string& text) {
  const std::size_t first = text.front() == '-' ? 1 : 0;
  const std::size_t point = std::min(text.find('.'), text.size());
  if (point - first < 5) return;
  for (std::size_t i = point; i > first + 3; i -= 3) text.insert(i - 3, "\u202f");
}

}  // namespace

std::string shortNumber(double value) {
  const double size = std::abs(value);
  const int digits =
      size >= 100 || size == 0.0 ? 0 : std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 1, 9);
  std::string text = fixed(value, digits);
  dropTrailingZeros(text);
  separateThousands(text);
  return text;
}

}  // namespace glissade
