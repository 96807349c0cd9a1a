#pragma once

#include <string>

#include "tests/oracle/vectors.h"

namespace glissade::oracle {

/// Reads the triangles of a mesh file in the simplest way: STL (text, binary), OBJ (v and f lines), GLB (one buffer,
/// nodes without transforms). Throws std::runtime_error if the file is malformed. It must not be used for hostile
/// files.
Triangles readTriangles(const std::string& file);

}  // namespace glissade::oracle
