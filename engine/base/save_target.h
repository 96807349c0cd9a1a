#pragma once

#include <sys/stat.h>

#include <string>

#include "engine/base/result.h"

namespace glissade {

/// The file that a save replaces. Private to the functions that write files.
struct SaveTarget {
  std::string file;  ///< as the user wrote it
  std::string path;  ///< with symbolic links followed
  bool exists = false;
  struct stat status {};  ///< where it exists

  /// Whether `now` is the same file with the same content, as far as the file system says.
  bool isSameAs(const struct stat& now) const;
};

/// Follows symbolic links. Errors: folders, pipes, devices, sockets, files that nobody or not this user may
/// write, names that are too long, folders that cannot be entered.
Result<SaveTarget> findSaveTarget(const std::string& file);

/// An error of the operating system during a save, with what helps against it. `error` is an errno.
Diagnostic saveError(const std::string& file, const std::string& what, int error);

}  // namespace glissade
