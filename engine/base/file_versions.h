#pragma once

#include <sys/stat.h>

#include <ctime>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace glissade {

/// Earlier versions of FILE lie in the hidden folder ".earlier-versions/FILE" beside it. Each is a whole file:
/// "000012_2026-11-22T17-13-44Z.json" is version 12, which was saved at that time (UTC).

/// How many versions a program of ours keeps of a scenario.
inline constexpr int kKeptVersions = 5;

struct FileVersion {
  std::string path;
  int number = 0;        ///< grows with each version that is kept
  std::time_t time = 0;  ///< when this content was saved
};

/// The latest first. Empty where there are none.
std::vector<FileVersion> earlierVersions(const std::string& file);

/// Keeps a content of the file as one more version. `status` is that of the file: its permissions and its time
/// become those of the version. Nothing is done where the latest version is the same content.
Outcome keepVersion(const std::string& file, const std::string& content, const struct stat& status);

/// Removes all but the latest ones. What cannot be removed stays.
void removeOldVersions(const std::string& file, int kept);

}  // namespace glissade
