#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace glissade {

/// Whether a file's name ends as those of STEP files do: .step or .stp, in any case.
inline bool hasStepEnding(const std::string& name) {
  std::string ending = name.substr(std::min(name.rfind('.'), name.size()));
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".step" || ending == ".stp";
}

}  // namespace glissade
