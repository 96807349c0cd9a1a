#pragma once

#include <string>

namespace glissade {

/// The whole work of the importing process: gives up its rights, reads standard input, parses
/// it as a file of that ending, writes the protocol's message to standard output. Returns the
/// process's exit code.
///
/// With import_protocol::kSeveral it reads several files and writes a message of each.
int confinedImport(const std::string& ending);

}  // namespace glissade
