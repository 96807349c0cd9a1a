#pragma once

#include <string>

#include "tests/oracle/vectors.h"

namespace glissade::oracle {

enum class MeshFormat { TextStl, BinaryStl, Obj, Glb };

std::string endingOf(MeshFormat format);
/// The content of a mesh file. Text has every digit; binary STL and GLB have single precision.
std::string meshFile(const Triangles& triangles, MeshFormat format);

}  // namespace glissade::oracle
