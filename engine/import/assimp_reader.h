#pragma once

#include <string>
#include <string_view>

#include "engine/import/mesh_exchange.h"

namespace glissade {

/// Reads a mesh file from memory with assimp. Only for the importing process: assimp may crash, hang
/// or corrupt memory on damaged files. Flags and node transformations are those of OMPL.app, so
/// that its mean of the vertices can be reproduced. Only the importer of the given ending runs.
/// Never throws.
MeshReply readMeshWithAssimp(std::string_view content, const std::string& ending);

}  // namespace glissade
