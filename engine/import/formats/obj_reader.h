#pragma once

#include <string_view>

#include "engine/import/formats/mesh_content.h"

namespace glissade {

/// Reads the polygons of an OBJ file; points and lines bound no solid and are skipped. A face that cannot be read as a
/// whole, and a free-form surface, is an error. Materials are not read. A group is what follows an "o" or a "g"
/// statement. Throws FormatError.
MeshContent readObj(std::string_view text);

}  // namespace glissade
