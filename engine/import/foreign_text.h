#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glissade {

/// How the names of a STEP file were read that are neither UTF-8 nor encoded as ISO 10303-21 says.
struct ForeignNames {
  std::string encoding;  ///< "GB18030", "Shift JIS", "Windows-1252"
  bool isSure = false;   ///< else the encoding could not be told
  std::string example;   ///< the first such name, as it was read; UTF-8
};

/// Reads names in encodings that the standard does not allow and programs write: GB18030, Shift JIS and Windows-1252, a
/// superset of Latin 1. The encoding is the one in which nearly all characters of the names are usual ones.
class ForeignText {
 public:
  /// Loads the converters of the C library, which needs files: to be made before confine().
  ForeignText();
  ~ForeignText();
  ForeignText(const ForeignText&) = delete;
  ForeignText& operator=(const ForeignText&) = delete;

  /// Makes the text UTF-8; nothing where it was.
  std::optional<ForeignNames> makeUtf8(std::vector<char>& text) const;

 private:
  static constexpr std::size_t kEncodings = 3;
  using Converter = void*;

  std::string decoded(std::string_view name, std::size_t encoding) const;

  std::array<Converter, kEncodings> converters_;
};

}  // namespace glissade
