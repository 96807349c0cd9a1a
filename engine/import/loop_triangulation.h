#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "engine/import/plane_point.h"

namespace glissade {

/// Indices of points, each joined to the next and the last to the first.
using PlaneLoop = std::vector<std::uint32_t>;

/// Counter-clockwise triangles; no point is new, and each side of a loop is the side of one triangle.
struct LoopTriangles {
  std::vector<TriangleIndices> triangles;
  /// Triangles that overlap others, because loops cross each other: their sides are right, their insides are not.
  std::size_t forced = 0;
};

/// Triangles between an outer loop, which runs counter-clockwise, and holes, which run clockwise. Nothing where the
/// outer loop runs the other way or a hole does, or where loops cross in very many places. The time is quadratic in
/// the points.
std::optional<LoopTriangles> triangulateLoops(const std::vector<PlanePoint>& points, std::vector<PlaneLoop> loops);

}  // namespace glissade
