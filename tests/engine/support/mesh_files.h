#pragma once

#include <string>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade::test {

/// How a mesh is written.
enum class MeshFormat {
  TextStl,
  BinaryStl,
  Obj,
  ObjPolygons,  ///< neighbouring coplanar triangles as quadrilaterals, normals, indices from the end
  TextPly,
  LittlePly,  ///< binary, 32-bit floats
  BigPly,     ///< binary, 64-bit floats
  Gltf,       ///< its data as base64
  Glb,
  Collada
};

inline constexpr MeshFormat kMeshFormats[] = {
    MeshFormat::TextStl,   MeshFormat::BinaryStl, MeshFormat::Obj,  MeshFormat::ObjPolygons, MeshFormat::TextPly,
    MeshFormat::LittlePly, MeshFormat::BigPly,    MeshFormat::Gltf, MeshFormat::Glb,         MeshFormat::Collada};

/// "stl", as a file of the format ends.
std::string endingOf(MeshFormat format);
/// The format holds decimal or 64-bit numbers.
bool isExact(MeshFormat format);

/// The content of a file that holds the solids, one after another. Decimal numbers read back bit by bit.
std::string meshFile(MeshFormat format, const std::vector<TriangleMesh>& solids);

/// The number of triangles of a file, counted by looking for its keywords and counts only.
std::size_t countTriangles(MeshFormat format, const std::string& content);

}  // namespace glissade::test
