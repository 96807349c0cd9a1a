#pragma once

#include <cstdint>
#include <string>

#include "engine/base/result.h"

namespace glissade {

/// A file with its bytes. They are read once, so that hash, check and parser see the same bytes.
struct FileContent {
  std::string file;
  std::string bytes;
};

/// Reads a regular file. Errors are MalformedInput; for a file larger than `mostBytes` with both sizes.
Result<FileContent> readContent(const std::string& file, std::uint64_t mostBytes);

}  // namespace glissade
