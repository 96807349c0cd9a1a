#include "engine/base/version_text.h"

#include <glissade/commit.h>
#include <glissade/version.h>

namespace glissade {

std::string versionText() {
  const std::string commit = kCommit;
  return commit.empty() ? kVersion : kVersion + (" (" + commit + ")");
}

}  // namespace glissade
