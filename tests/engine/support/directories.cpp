#include "tests/engine/support/directories.h"

namespace glissade::test {

std::string sourceDirectory() { return GLISSADE_SOURCE_DIR; }

std::string programDirectory() { return GLISSADE_BIN_DIR; }

std::string stepFileDirectory() { return GLISSADE_STEP_FILES; }

}  // namespace glissade::test
