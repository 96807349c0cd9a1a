#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glissade {

/// The encoding of names in a STEP file that are neither UTF-8 nor encoded by ISO 10303-21.
struct ForeignNames {
  std::string encoding;  ///< "GB18030", "Shift JIS", "Windows-1252"
  bool isSure = false;   ///< false: the encoding is uncertain
  std::string example;   ///< the first such name as it was decoded; UTF-8
};

/// Decodes names in encodings that the standard does not permit but programs write: GB18030, Shift JIS and
/// Windows-1252, a superset of Latin 1. It takes the encoding in which nearly all characters of the names are usual
/// ones.
class ForeignText {
 public:
  /// Loads the converters of the C library, which needs files: construct it before confine().
  ForeignText();
  ~ForeignText();
  ForeignText(const ForeignText&) = delete;
  ForeignText& operator=(const ForeignText&) = delete;

  /// Converts the text to UTF-8; nothing if it is UTF-8. Names in UTF-8 whose last character is cut do not count: that
  /// character becomes U+FFFD.
  std::optional<ForeignNames> makeUtf8(std::vector<char>& text) const;

 private:
  static constexpr std::size_t kEncodings = 3;
  using Converter = void*;

  std::string decoded(std::string_view name, std::size_t encoding) const;

  std::array<Converter, kEncodings> converters_;
};

}  // namespace glissade
