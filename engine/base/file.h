#pragma once

#include <cstddef>
#include <string>

#include "engine/base/result.h"

namespace glissade {

/// The whole content of a regular file. Folders, pipes, devices, files larger than `mostBytes` and files that cannot be
/// read are MalformedInput errors; never blocks on a pipe.
Result<std::string> readFile(const std::string& file, std::size_t mostBytes);

/// Replaces a file so that after any failure or power cut either the old or the new content is there:
/// write beside it, flush, read back and compare, rename, flush the folder.
Outcome writeFileAtomically(const std::string& file, const std::string& content);

/// SHA-256 of a text, as 64 lower-case hexadecimal digits.
std::string sha256(const std::string& content);

/// The folder part of a path; "." where there is none.
std::string folderOf(const std::string& file);

/// The ending of a file's name in lower case, without its dot.
std::string endingOf(const std::string& file);

}  // namespace glissade
