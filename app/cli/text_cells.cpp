#include "app/cli/text_cells.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace glissade::cli {
namespace {

std::string spacesUpTo(std::size_t width, const std::string& text) {
  return std::string(std::max(width, widthOf(text)) - widthOf(text), ' ');
}

}  // namespace

std::size_t widthOf(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string toLeft(const std::string& text, std::size_t width) { return text + spacesUpTo(width, text); }

std::string toRight(const std::string& text, std::size_t width) { return spacesUpTo(width, text) + text; }

std::string rounded(double value, int digits) {
  std::ostringstream text;
  text << std::setprecision(digits) << value;
  return text.str();
}

std::string fixedDigits(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

}  // namespace glissade::cli
