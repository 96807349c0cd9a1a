#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/check/piece_tree.h"
#include "engine/geometry/triangle_mesh.h"

namespace glissade::check {

/// Edges of a path, one after the other, that are one screw motion of more than a full turn, as the judge finds
/// it by itself.
struct Helix {
  std::size_t first = 0;  ///< edge
  std::size_t last = 0;   ///< edge, the last of them
  Vector3 point = Vector3::Zero();
  Vector3 axis = Vector3::UnitZ();
  double lead = 0.0;     ///< along the axis for a full turn by the right hand
  double advance = 0.0;  ///< along the axis, from the first configuration to the last
  double off = 0.0;      ///< no vertex is farther from where the exact motion has it
};

std::vector<Helix> helicesOf(const std::vector<Pose>& path, const TriangleMesh& object);

/// Lower bound on the distance of two sets of triangles for every turn of the motion, from the triangles' profiles:
/// distance from the axis, and height less that of the helix through the point. Compares every pair; triangles are
/// divided where that is needed to show `wanted`. At most `enough`; 0: nothing is shown, or it was stopped.
double helixDistance(const std::vector<Corners>& moving, const std::vector<Corners>& fixed, const Helix& helix,
                     double wanted, double enough, const StopToken& stop);

}  // namespace glissade::check
