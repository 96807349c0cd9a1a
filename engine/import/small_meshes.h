#pragma once

#include <optional>
#include <vector>

#include "engine/import/mesh_import.h"

namespace glissade {

/// True if a file of `bytes` bytes may be read together with others: it is small, and this project reads its format.
bool isSmallMesh(const std::string& file, std::uint64_t bytes);

/// The results of importMesh() for these files. Several files are read in one confined process, and several processes
/// run at the same time. A process has the limits of one file. Nothing for a file that has to be read alone: it has an
/// error, or the process did not reach it. Precondition: isSmallMesh().
std::vector<std::optional<ImportedMesh>> importSmallMeshes(const std::vector<FileContent>& files,
                                                           const StopToken& stop = {});

}  // namespace glissade
