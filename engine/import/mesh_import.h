#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/import/file_content.h"
#include "engine/import/formats/mesh_content.h"

namespace glissade {

/// A mesh as its file has it.
struct ImportedMesh {
  TriangleMesh mesh;  ///< equal positions are one vertex; triangles with two equal corners are still there
  /// Mean of the corners that differ in position, normal or texture coordinates, in single precision: the
  /// reference point that OMPL.app gives to its robots.
  Vector3 vertexMean = Vector3::Zero();
  /// Where the format holds 32-bit floats: their spacing at the largest coordinate, units of the file. A vertex may
  /// be that far from where the program that wrote the file had it. 0 where the format holds decimal or 64-bit numbers.
  double coordinateSpacing = 0.0;
  Warnings warnings;  ///< of the file
  /// Of an OBJ file: which triangles are of which group, in their order. Names are on one line.
  std::vector<GroupRun> groups;
};

/// Imports STL, OBJ, PLY, DAE, glTF (embedded) and GLB. The file is parsed in a process of its own that can open no
/// file and has limited memory and time, because malformed files crash or hang parsers; every number and index is
/// checked again here. Only equal positions become one vertex, and no triangle is left out.
///
/// Coordinates: node transforms are applied. A Collada file's own unit and up-axis are honoured by
/// assimp (the result is in metres and y-up); other formats carry neither. What a unit means and
/// which axis is up is the caller's choice on top of that.
///
/// Errors are MalformedInput with the file's name and, for STL, OBJ and PLY, the line or byte. A mesh whose
/// coordinate spacing is more than a ten-thousandth of its diagonal is an error. Interrupted is the error where it was
/// stopped.
Result<ImportedMesh> importMesh(const FileContent& content, const StopToken& stop = {});
Result<ImportedMesh> importMesh(const std::string& file, const StopToken& stop = {});

/// Whether the ending is one that importMesh reads.
bool isMeshFile(const std::string& file);

}  // namespace glissade
