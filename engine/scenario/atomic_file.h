#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace glissade {

/// Replaces a file as a whole or not at all: writes beside it, syncs, reads back and compares, renames
/// over it, and syncs the folder. After any failure (disk full, no permission, power cut) the old
/// file is intact. Errors are Internal and name the file.
Outcome writeFileAtomically(const std::string& file, std::string_view content);

}  // namespace glissade
