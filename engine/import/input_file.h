#pragma once

#include <cstddef>
#include <string>

#include "engine/base/result.h"

namespace glissade {

/// Largest files that are read, bytes. A text file's parsed form takes several times its size.
inline constexpr std::size_t kLargestTextFile = std::size_t{16} << 20;
inline constexpr std::size_t kLargestMeshFile = std::size_t{128} << 20;

/// The content of a file that somebody gave us. Never blocks: only regular files are read (no
/// directory, FIFO or device), and none above `largestBytes`. Errors are MalformedInput.
Result<std::string> readInputFile(const std::string& file, std::size_t largestBytes);

/// `relative` is a relative path, separated by '/', without "..". Looks at no file.
bool isRelativeInside(const std::string& relative);

/// `relative` (separated by '/') inside `folder`, as a path that can be opened. Refuses what is
/// absolute, has a ".." or leads out of the folder through a symbolic link. The file need not exist.
/// Errors are MalformedInput with an empty file and place: the caller knows who asked.
Result<std::string> resolveInside(const std::string& folder, const std::string& relative);

/// The part of a path before its last '/', "." where there is none.
std::string folderOf(const std::string& file);

/// The ending of a file name in lower case and without its dot; empty where there is none.
std::string endingOf(const std::string& file);

}  // namespace glissade
