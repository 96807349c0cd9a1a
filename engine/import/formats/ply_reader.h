#pragma once

#include <string_view>

#include "engine/import/formats/mesh_content.h"

namespace glissade {

/// Reads the vertices and faces of a PLY file: text, or binary in either order of bytes. Other elements and
/// properties are skipped, except triangle strips, which are an error. A file that is longer or shorter than its
/// header says is an error. Throws FormatError.
MeshContent readPly(std::string_view bytes);

}  // namespace glissade
