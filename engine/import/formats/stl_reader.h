#pragma once

#include <string_view>

#include "engine/import/formats/mesh_content.h"

namespace glissade {

/// Reads an STL file, text or binary. Text that holds anything but whole facets in whole solids is an error, and so
/// is a binary file whose length differs from what its number of triangles needs. Throws FormatError.
MeshContent readStl(std::string_view bytes);

}  // namespace glissade
