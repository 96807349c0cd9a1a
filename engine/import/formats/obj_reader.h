#pragma once

#include <string_view>

#include "engine/import/formats/mesh_content.h"

namespace glissade {

/// Reads the polygons of an OBJ file; points and lines are skipped. A face that cannot be read completely, and a
/// free-form surface, is an error. Materials are not read. "o" and "g" statements begin a group. Throws FormatError.
MeshContent readObj(std::string_view text);

}  // namespace glissade
