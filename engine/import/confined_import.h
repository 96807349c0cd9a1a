#pragma once

#include <string>

namespace glissade {

/// The whole work of the importing process: gives up its rights, reads standard input, parses
/// it as a file of that ending, writes the protocol's message to standard output. Returns the
/// process's exit code.
int confinedImport(const std::string& ending);

}  // namespace glissade
