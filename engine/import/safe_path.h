#pragma once

#include <filesystem>
#include <string>

#include "engine/base/result.h"

namespace glissade {

/// The file `name` (relative, '/' as separator) below `folder`. Refuses absolute names and names that leave the folder,
/// even through symbolic links. `file` and `location` are used in the message.
inline Result<std::string> resolveBelow(const std::string& folder, const std::string& name, const std::string& file,
                                        const Location& location) {
  namespace fs = std::filesystem;
  const Diagnostic refused{ErrorKind::MalformedInput,
                           file,
                           location,
                           {GLISSADE_TEXT("the file name '%1' leaves the folder"), {name}},
                           GLISSADE_TEXT("Put the file beside the scenario or below it and name it relative to it.")};
  const fs::path relative(name);
  if (name.empty() || relative.is_absolute()) return refused;
  std::error_code error;
  const fs::path base = fs::weakly_canonical(fs::path(folder), error);
  const fs::path target = fs::weakly_canonical(base / relative, error);
  const fs::path inside = target.lexically_relative(base);
  if (error || inside.empty() || *inside.begin() == "..") return refused;
  return (fs::path(folder) / relative).lexically_normal().string();
}

}  // namespace glissade
