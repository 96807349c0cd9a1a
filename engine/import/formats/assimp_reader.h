#pragma once

#include <string>
#include <string_view>

#include "engine/import/formats/mesh_content.h"

namespace glissade {

/// Parses a file with that ending by assimp. Coordinates are the 32-bit floats of assimp; the transforms of nodes are
/// applied in double precision. Throws FormatError.
MeshContent readWithAssimp(std::string_view bytes, const std::string& ending);

}  // namespace glissade
