#pragma once

#include <sys/stat.h>

#include <string>

#include "engine/base/result.h"

namespace glissade {

/// The file that a save replaces. Private to the functions that write files.
struct SaveTarget {
  std::string file;  ///< path as the user wrote it
  std::string path;  ///< path with symbolic links followed
  bool exists = false;
  struct stat status {};  ///< status if the file exists

  /// True if `now` is the same file with the same content, by the file system's data.
  bool isSameAs(const struct stat& now) const;
};

/// Follows symbolic links. Errors: folders, pipes, devices, sockets, files that this user may not write, names that are
/// too long, folders that cannot be entered.
Result<SaveTarget> findSaveTarget(const std::string& file);

/// An error of the operating system during a save, with a remedy. `error` is an errno.
Diagnostic saveError(const std::string& file, const Message& what, int error);

}  // namespace glissade
