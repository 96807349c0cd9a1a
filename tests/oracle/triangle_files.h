#pragma once

#include <string>

#include "tests/oracle/vectors.h"

namespace glissade::oracle {

/// Reads the triangles of a mesh file as naively as its format allows: STL (text, binary), OBJ (v and f lines),
/// GLB (one buffer, nodes without transforms). Throws std::runtime_error where the file is not what the format
/// says. It is not for hostile files.
Triangles readTriangles(const std::string& file);

}  // namespace glissade::oracle
