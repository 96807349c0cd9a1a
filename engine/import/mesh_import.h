#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade {

enum class UpAxis { Y, Z };

/// How the numbers of a mesh file are understood. STL, OBJ, FBX and X3D arrive as they are written;
/// glTF is in metres and Y-up by definition. A Collada file declares its unit and up-axis, and assimp
/// carries both out: its numbers arrive in metres and Y-up. 3DS files, Z-up by custom, arrive Y-up
/// too. `unit` and `up` are applied on top of that, to what arrives:
/// - `unit`: metres for one unit of what arrives; positive.
/// - `up`: Y turns what arrives by a quarter about x, so that its y axis becomes the world's z;
///   Z leaves it as it is.
/// So glTF, Collada and 3DS files stand as their authors meant them with {unit, Y}; what OMPL.app
/// sees of a Collada file is {1, Z}.
struct MeshInterpretation {
  double unit = 1.0;
  UpAxis up = UpAxis::Z;
};

struct ImportedMesh {
  TriangleMesh mesh;   ///< welded, metres, Z-up
  Vector3 vertexMean;  ///< of the vertices as imported (duplicates included), summed in float as OMPL.app does
  std::string sha256;  ///< of the file's content
};

/// Reads STL, OBJ (material files are ignored), Collada, glTF 2 (self-contained), 3DS, FBX or X3D in
/// a confined process (see import_process.h). Errors are MalformedInput and name the file.
Result<ImportedMesh> importMesh(const std::string& file, const MeshInterpretation& interpretation);

}  // namespace glissade
