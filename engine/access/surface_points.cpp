#include "engine/access/surface_points.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

// The plastic number's sequence spreads points evenly over a square.
constexpr double kFirstShare = 0.7548776662466927;
constexpr double kSecondShare = 0.5698402909980532;

double areaOf(const TriangleMesh& mesh, const TriangleIndices& corners) {
  const Vector3& a = mesh.vertices[corners[0]];
  return 0.5 * (mesh.vertices[corners[1]] - a).cross(mesh.vertices[corners[2]] - a).norm();
}

/// The `number`-th point of the sequence in a triangle.
Vector3 pointIn(const TriangleMesh& mesh, const TriangleIndices& corners, std::size_t number) {
  double first = std::fmod(kFirstShare * static_cast<double>(number + 1), 1.0);
  double second = std::fmod(kSecondShare * static_cast<double>(number + 1), 1.0);
  if (first + second > 1.0) {
    first = 1.0 - first;
    second = 1.0 - second;
  }
  const Vector3& a = mesh.vertices[corners[0]];
  return a + first * (mesh.vertices[corners[1]] - a) + second * (mesh.vertices[corners[2]] - a);
}

}  // namespace

std::vector<SurfacePoint> surfacePoints(const TriangleMesh& mesh, std::size_t count) {
  std::vector<double> areas;
  double whole = 0.0;
  for (const TriangleIndices& corners : mesh.triangles) areas.push_back(whole += areaOf(mesh, corners));
  std::vector<SurfacePoint> points;
  if (!(whole > 0.0)) return points;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = whole * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const auto triangle = static_cast<std::size_t>(std::lower_bound(areas.begin(), areas.end(), at) - areas.begin());
    const TriangleIndices& corners = mesh.triangles[triangle];
    points.push_back({pointIn(mesh, corners, i), faceNormal(mesh, corners)});
  }
  return points;
}

}  // namespace glissade
