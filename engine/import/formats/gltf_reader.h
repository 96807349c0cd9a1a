#pragma once

#include <string_view>

#include "engine/import/formats/mesh_content.h"

namespace glissade {

/// Reads the triangles of a glTF or GLB file's scene. Transforms of nodes are applied in double precision. A required
/// extension that changes the surface and is not known is an error; morph targets and skins are not applied, which
/// is a warning. Throws FormatError.
MeshContent readGltf(std::string_view bytes);

}  // namespace glissade
