#pragma once

#include <string>

namespace glissade {

/// The version and, if the sources are a Git repository, the commit of the build: "0.1.0 (1a2b3c4)". The suffix
/// "-dirty" says that the sources had changes that no commit holds.
std::string versionText();

}  // namespace glissade
