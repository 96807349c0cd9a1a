#pragma once

#include <string_view>

#include "engine/import/formats/mesh_content.h"

namespace glissade {

/// Reads the triangles of the scene of a glTF or GLB file. Transforms of nodes are applied in double precision. An
/// unknown required extension that changes the surface is an error; morph targets and skins are not applied, with a
/// warning. Throws FormatError.
MeshContent readGltf(std::string_view bytes);

}  // namespace glissade
