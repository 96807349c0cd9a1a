#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/assembly/node_names.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A part placed in a product, as its file has it. Occurrences of one part share its mesh.
struct Occurrence {
  /// Its place in the tree of the file (body_path.h), each once: "pump/rotor", "pin#2". Empty where the file, or what
  /// of it is meant, holds one part.
  std::string path;
  MeshPtr mesh;                                   ///< in the part's frame P, metres
  Pose X_FP;                                      ///< in the file's frame F, metres and z up
  std::optional<std::array<double, 3>> colour{};  ///< sRGB
  double deflection = 0.0;           ///< metres that the mesh is off a STEP surface, the most of its faces; else 0
  std::size_t facesWithoutMesh = 0;  ///< of STEP: faces and boundaries that could not be made are missing
  bool isClosed = false;             ///< known to be a closed surface; else it is to be found out
  double coordinateSpacing = 0.0;    ///< metres that the mesh may be off the file: want of digits, closed T-junctions
  /// The names of the steps of `path` as the file has them. None at all where they are the steps themselves.
  std::vector<NodeNames> names{};
  double unit = 0.0;  ///< metres: that in which a STEP file states its lengths; 0: the file states none
  /// Its path in scenarios and plans of earlier versions; empty: the same.
  std::string formerPath{};
  bool isSolidOfPart = false;  ///< one of several solids of the part that is the node above it
};

}  // namespace glissade
