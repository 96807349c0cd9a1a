#pragma once

#include <string>

namespace glissade {

/// The version and, where the sources are a Git repository, the commit that the program was built of: "0.1.0
/// (1a2b3c4)".
/// "-dirty" follows the commit where the sources had changes that are in no commit.
std::string versionText();

}  // namespace glissade
