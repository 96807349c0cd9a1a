#pragma once

#include <string>
#include <string_view>

#include "engine/import/formats/mesh_content.h"

namespace glissade {

/// Lets assimp parse a file of that ending. Coordinates are those that assimp holds, which are 32-bit floats; the
/// transforms of nodes are applied in double precision. Throws FormatError.
MeshContent readWithAssimp(std::string_view bytes, const std::string& ending);

}  // namespace glissade
