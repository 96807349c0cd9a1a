#include "engine/base/printable_text.h"

#include "engine/base/utf8.h"

namespace glissade {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// Precondition: a whole UTF-8 character.
char32_t codePointOf(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 1) return byte(0);
  char32_t code = byte(0) & (0x7fU >> character.size());
  for (std::size_t i = 1; i < character.size(); ++i) code = code << 6U | (byte(i) & 0x3fU);
  return code;
}

bool isControl(char32_t code) { return code < 0x20 || (code >= 0x7f && code < 0xa0); }

bool reordersOrBreaksLines(char32_t code) {
  return (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) || code == 0x2028 || code == 0x2029;
}

std::string printable(std::string_view text, std::string_view allowedControls) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8LengthAt(text, at);
    const std::string_view character = text.substr(at, length == 0 ? 1 : length);
    const char32_t code = length == 0 ? 0 : codePointOf(character);
    const bool allowed = length == 1 && allowedControls.find(character) != std::string_view::npos;
    const bool replaced = length == 0 || (isControl(code) && !allowed) || reordersOrBreaksLines(code);
    result += replaced ? kReplacement : character;
    at += character.size();
  }
  return result;
}

}  // namespace

std::string printableText(std::string_view text) { return printable(text, "\n\t"); }

std::string printableLine(std::string_view text) { return printable(text, ""); }

}  // namespace glissade
