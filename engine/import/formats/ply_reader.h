#pragma once

#include <string_view>

#include "engine/import/formats/mesh_content.h"

namespace glissade {

/// Reads the vertices and faces of a PLY file: text, or binary with either byte order. Other elements and properties
/// are skipped, except triangle strips, which are an error. A file that is longer or shorter than its header states is
/// an error. Throws FormatError.
MeshContent readPly(std::string_view bytes);

}  // namespace glissade
