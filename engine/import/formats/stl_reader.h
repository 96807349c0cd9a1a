#pragma once

#include <string_view>

#include "engine/import/formats/mesh_content.h"

namespace glissade {

/// Reads an STL file, text or binary. Text with anything except complete facets in complete solids is an error, and so
/// is a binary file whose length does not match its number of triangles. Throws FormatError.
MeshContent readStl(std::string_view bytes);

}  // namespace glissade
