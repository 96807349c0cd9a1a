#pragma once

#include <cstdint>
#include <string>

#include "engine/import/importer_process.h"
#include "engine/import/mesh_import.h"

namespace glissade {

/// The call of glissade-import for a file of `bytes` bytes, with the limits on this machine.
ImporterCall meshImporterCall(const std::string& argument, const std::string& file, std::uint64_t bytes);

/// The mesh that follows a header in a message. Every number and index is checked. All of it is taken from the message,
/// even if it is refused, unless the message ends before.
Result<ImportedMesh> decodeMeshAnswer(const ImporterCall& call, const import_protocol::Header& header,
                                      ImportMessage& message);

}  // namespace glissade
