#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/geometry/triangle_mesh.h"
#include "engine/import/plane_point.h"

namespace glissade {

/// Indices of points; each is joined to the next, and the last one to the first.
using PlaneLoop = std::vector<std::uint32_t>;

/// Counter-clockwise triangles without new points; each side of a loop is the side of one triangle.
struct LoopTriangles {
  std::vector<TriangleIndices> triangles;
  /// Number of triangles that overlap others because loops cross: their sides are right, their insides are not.
  std::size_t forced = 0;
};

/// Triangles between a counter-clockwise outer loop and clockwise holes. Nothing if a loop has the wrong sense, or if
/// loops cross in very many places. The time is quadratic in the number of points.
std::optional<LoopTriangles> triangulateLoops(const std::vector<PlanePoint>& points, std::vector<PlaneLoop> loops);

}  // namespace glissade
