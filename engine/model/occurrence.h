#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "engine/model/node_names.h"

namespace glissade {

/// A part placed in a product, as its file states it. Occurrences of one part share its mesh.
struct Occurrence {
  /// Unique path in the tree of the file (body_path.h): "pump/rotor", "pin#2". Empty if the file, or the chosen part of
  /// it, contains one part.
  std::string path;
  MeshPtr mesh;                                   ///< in the part's frame P, metres
  Pose X_FP;                                      ///< in the file's frame F, metres and z up
  std::optional<std::array<double, 3>> colour{};  ///< sRGB
  double deflection = 0.0;                        ///< largest deviation of the mesh from a STEP surface, metres; else 0
  std::size_t facesWithoutMesh = 0;  ///< number of faces and boundaries of a STEP file that could not be made
  bool isClosed = false;             ///< the mesh is known to be closed; false: not known
  double coordinateSpacing = 0.0;    ///< largest deviation from the file, metres: limited digits, closed T-junctions
  /// The names of the steps of `path`, as the file states them. Empty if they equal the steps.
  std::vector<NodeNames> names{};
  double unit = 0.0;  ///< metres: unit in which a STEP file states lengths; 0: the file states none
  /// Path in scenarios and plans of earlier versions; empty: equal to `path`.
  std::string formerPath{};
  bool isSolidOfPart = false;  ///< the node above is a part with several solids, of which this is one
};

}  // namespace glissade
