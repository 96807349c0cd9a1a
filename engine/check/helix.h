#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/check/piece_tree.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade::check {

/// Consecutive edges of a path that form one screw motion of more than a full turn. The judge finds them independently
/// of the planners.
struct Helix {
  std::size_t first = 0;  ///< index of the first edge
  std::size_t last = 0;   ///< index of the last edge
  Vector3 point = Vector3::Zero();
  Vector3 axis = Vector3::UnitZ();
  double lead = 0.0;     ///< advance along the axis for a right-handed full turn
  double advance = 0.0;  ///< advance along the axis from the first configuration to the last
  double off = 0.0;      ///< upper bound on the deviation of a vertex from the exact motion
};

std::vector<Helix> helicesOf(const std::vector<Pose>& path, const TriangleMesh& object);

/// Lower bound on the distance of two sets of triangles for every turn of the motion. It compares the profiles of all
/// pairs of triangles: the distance from the axis, and the height minus that of the helix through the point. Triangles
/// are divided if that is needed to show `wanted`. The result is at most `enough`; 0 if no bound is shown, or after a
/// stop.
double helixDistance(const std::vector<Corners>& moving, const std::vector<Corners>& fixed, const Helix& helix,
                     double wanted, double enough, const StopToken& stop);

}  // namespace glissade::check
