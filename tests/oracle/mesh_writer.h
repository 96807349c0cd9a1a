#pragma once

#include <string>

#include "tests/oracle/vectors.h"

namespace glissade::oracle {

enum class MeshFormat { TextStl, BinaryStl, Obj, Glb };

std::string endingOf(MeshFormat format);
/// Text holds every digit; binary STL and GLB hold what single precision can.
std::string meshFile(const Triangles& triangles, MeshFormat format);

}  // namespace glissade::oracle
