#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace glissade {

/// Decodes a base64 text (RFC 4648); nothing if it is malformed.
inline std::optional<std::string> decodeBase64(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t collected = 0;
  int bits = 0;
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    collected = (collected << 6U) | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>((collected >> static_cast<unsigned>(bits)) & 0xffU);
  }
  if (bits >= 6) return std::nullopt;
  return bytes;
}

}  // namespace glissade
