#pragma once

#include <sys/stat.h>

#include <ctime>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace glissade {

/// Earlier versions of FILE lie in the hidden folder ".earlier-versions/FILE" beside it. Each is a whole file:
/// "000012_2026-11-22T17-13-44Z.json" is version 12, which was saved at that time (UTC).

/// Number of versions of a scenario that our programs keep.
inline constexpr int kKeptVersions = 5;

struct FileVersion {
  std::string path;
  int number = 0;        ///< number that grows with each kept version
  std::time_t time = 0;  ///< time at which this content was saved
};

/// Earlier versions, the latest first. Empty where there are none.
std::vector<FileVersion> earlierVersions(const std::string& file);

/// Keeps a content of the file as another version. `status` is that of the file: the version gets its permissions and
/// its time. Does nothing where the latest version has the same content.
Outcome keepVersion(const std::string& file, const std::string& content, const struct stat& status);

/// Removes all but the latest versions. A version that cannot be removed stays.
void removeOldVersions(const std::string& file, int kept);

}  // namespace glissade
