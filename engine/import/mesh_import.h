#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A mesh as its file has it.
struct ImportedMesh {
  TriangleMesh mesh;  ///< vertices as imported: duplicates from split normals included
  /// Mean of the imported vertices, accumulated in single precision: the reference point that
  /// OMPL.app gives to its robots.
  Vector3 vertexMean = Vector3::Zero();
};

/// Imports STL, OBJ, DAE, glTF (embedded) and GLB. The parsing is done by assimp in a process of its
/// own that can open no file and has little memory and time, because malformed files crash or hang
/// it; every number and index is checked again here.
///
/// Coordinates: node transforms are applied. A Collada file's own unit and up-axis are honoured by
/// assimp (the result is in metres and y-up); other formats carry neither. What a unit means and
/// which axis is up is the caller's choice on top of that.
///
/// Errors are MalformedInput with the file's name.
Result<ImportedMesh> importMesh(const std::string& file);

/// Whether the ending is one that importMesh reads.
bool isMeshFile(const std::string& file);

}  // namespace glissade
