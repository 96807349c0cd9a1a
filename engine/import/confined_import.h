#pragma once

#include <string>

namespace glissade {

/// The work of the importing process: gives up its rights, reads standard input, parses it as a file with that ending,
/// and writes the protocol's message to standard output. Returns the exit code of the process.
///
/// With import_protocol::kSeveral it reads several files and writes a message for each.
int confinedImport(const std::string& ending);

}  // namespace glissade
