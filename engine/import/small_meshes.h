#pragma once

#include <optional>
#include <vector>

#include "engine/import/mesh_import.h"

namespace glissade {

/// Whether a file of so many bytes may be read together with others: small, and of a format with a reader of our own.
bool isSmallMesh(const std::string& file, std::uint64_t bytes);

/// What importMesh() makes of each of these files, several of them in one confined process and several processes at the
/// same time. A process has the limits that one file has. Nothing stands for a file that is to be read alone: there is
/// an error, or the process did not get so far. Precondition: isSmallMesh().
std::vector<std::optional<ImportedMesh>> importSmallMeshes(const std::vector<FileContent>& files,
                                                           const StopToken& stop = {});

}  // namespace glissade
