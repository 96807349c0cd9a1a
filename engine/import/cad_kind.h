#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string>
#include <utility>

namespace glissade {

/// Kinds of files that OpenCASCADE reads in a confined process.
enum class CadKind { Step, Iges, Brep };

/// "STEP", "IGES" or "BREP".
inline const char* nameOf(CadKind kind) {
  return kind == CadKind::Step ? "STEP" : kind == CadKind::Iges ? "IGES" : "BREP";
}

/// The kind by the ending of a file's name, in any case; nothing for other endings.
inline std::optional<CadKind> cadKindOf(const std::string& name) {
  static constexpr std::array<std::pair<const char*, CadKind>, 7> kEndings{{{".step", CadKind::Step},
                                                                            {".stp", CadKind::Step},
                                                                            {".p21", CadKind::Step},
                                                                            {".iges", CadKind::Iges},
                                                                            {".igs", CadKind::Iges},
                                                                            {".brep", CadKind::Brep},
                                                                            {".brp", CadKind::Brep}}};
  std::string ending = name.substr(std::min(name.rfind('.'), name.size()));
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const auto& [known, kind] : kEndings) {
    if (ending == known) return kind;
  }
  return std::nullopt;
}

inline bool hasStepEnding(const std::string& name) { return cadKindOf(name) == CadKind::Step; }

}  // namespace glissade
