#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// Neighbouring triangles of a mesh file that belong to one named group.
struct GroupRun {
  std::string name;  ///< on one line; may be empty
  std::uint32_t triangles = 0;
};

/// A mesh as the reader of its format returns it, in the units and axes of the file.
struct MeshContent {
  TriangleMesh mesh;  ///< equal positions are one vertex; triangles with two equal corners are still there
  Vector3 vertexMean = Vector3::Zero();  ///< as ImportedMesh has it
  double coordinateSpacing = 0.0;        ///< likewise
  std::vector<std::string> warnings;     ///< each names its line
  std::vector<GroupRun> groups;          ///< of all triangles, in their order; none: the format has no groups
};

/// What is wrong with a file and where. Readers throw it; the importing process turns it into its message.
struct FormatError {
  std::string location;  ///< "line 12", "byte 934", or empty
  std::string reason;    ///< sentence fragment, for people
};

/// Spacing of 32-bit floating-point numbers at a magnitude.
double floatSpacing(double magnitude);

/// A word of a file as a message can show it: in quotes, without control characters, and not too long.
std::string inQuotes(std::string_view word);

}  // namespace glissade
