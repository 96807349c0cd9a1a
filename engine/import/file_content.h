#pragma once

#include <cstdint>
#include <string>

#include "engine/base/result.h"

namespace glissade {

/// A file and its bytes, read once: what is hashed, checked and parsed is the same.
struct FileContent {
  std::string file;
  std::string bytes;
};

/// Reads a regular file. Errors are MalformedInput; where the file is larger than `mostBytes`, with both sizes.
Result<FileContent> readContent(const std::string& file, std::uint64_t mostBytes);

}  // namespace glissade
