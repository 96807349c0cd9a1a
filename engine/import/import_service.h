#pragma once

#include <string>

namespace glissade {

/// The importing program: enters the sandbox, imports the mesh on standard input with the importer of
/// that ending, and writes an encoded MeshReply to standard output. Returns the exit code.
int serveImport(const std::string& ending);

}  // namespace glissade
