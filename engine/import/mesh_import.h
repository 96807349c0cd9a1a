#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/geometry/triangle_mesh.h"
#include "engine/import/file_content.h"
#include "engine/import/formats/mesh_content.h"

namespace glissade {

/// A mesh as its file states it.
struct ImportedMesh {
  TriangleMesh mesh;  ///< equal positions are one vertex; triangles with two equal corners are kept
  /// Mean of the corners that differ in position, normal or texture coordinates, in single precision: the reference
  /// point that OMPL.app gives to its robots.
  Vector3 vertexMean = Vector3::Zero();
  /// For formats with 32-bit floats, their spacing at the largest coordinate, in units of the file: the largest
  /// deviation of a vertex from its value in the program that wrote the file. 0 for formats with decimal or 64-bit
  /// numbers.
  double coordinateSpacing = 0.0;
  Warnings warnings;  ///< warnings about the file
  /// For an OBJ file, the groups of the triangles, in their order. Each name is on one line.
  std::vector<GroupRun> groups;
};

/// Imports STL, OBJ, PLY, DAE, glTF (embedded) and GLB. A separate process parses the file. It can open no file and has
/// limited memory and time, because malformed files crash or hang parsers. Every number and index is checked again
/// here. Only equal positions become one vertex, and no triangle is left out.
///
/// Coordinates: node transforms are applied. Assimp applies the unit and the up-axis of a Collada file (the result is
/// in metres and y-up); other formats state neither. The caller chooses the meaning of a unit and the up-axis of the
/// result.
///
/// Errors are MalformedInput with the file's name and, for STL, OBJ and PLY, the line or byte. A mesh whose coordinate
/// spacing exceeds a ten-thousandth of its diagonal is an error. Interrupted is the error after a stop.
Result<ImportedMesh> importMesh(const FileContent& content, const StopToken& stop = {});
Result<ImportedMesh> importMesh(const std::string& file, const StopToken& stop = {});

/// True if importMesh() reads files with this ending.
bool isMeshFile(const std::string& file);

}  // namespace glissade
