#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/diagnostic.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// Consecutive triangles of a mesh file that belong to one named group.
struct GroupRun {
  std::string name;  ///< on one line; may be empty
  std::uint32_t triangles = 0;
};

/// A mesh as the reader of its format returns it, in the units and axes of the file.
struct MeshContent {
  TriangleMesh mesh;                     ///< equal positions are one vertex; triangles with two equal corners are kept
  Vector3 vertexMean = Vector3::Zero();  ///< see ImportedMesh::vertexMean
  double coordinateSpacing = 0.0;        ///< see ImportedMesh::coordinateSpacing
  std::vector<Message> warnings;         ///< each names its line
  std::vector<GroupRun> groups;          ///< groups of all triangles, in their order; empty: the format has no groups
};

/// An error in a file, with its place. Readers throw it; the importing process writes it as its message.
struct FormatError {
  Location location;  ///< "line 12", "byte 934", or empty
  Message reason;     ///< sentence fragment
};

/// Spacing of 32-bit floating-point numbers at a magnitude.
double floatSpacing(double magnitude);

/// A word of a file for a message: in quotes, without control characters, and of limited length.
std::string inQuotes(std::string_view word);

}  // namespace glissade
