#include "engine/geometry/fcl_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade {
namespace {

/// Scaled coordinates are at most 2^150, because FCL multiplies up to six lengths.
constexpr int kLargestExponent = 150;

/// The smallest doubled area of triangles that are not degenerate, and the largest coordinate.
struct Extremes {
  double smallestArea = std::numeric_limits<double>::infinity();
  double largestCoordinate = 0.0;

  void add(const TriangleMesh& mesh) {
    for (const Vector3& vertex : mesh.vertices) {
      largestCoordinate = std::max(largestCoordinate, vertex.cwiseAbs().maxCoeff());
    }
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vector3& corner = mesh.vertices[a];
      const double area = (mesh.vertices[b] - corner).cross(mesh.vertices[c] - corner).norm();
      if (area > 0.0) smallestArea = std::min(smallestArea, area);
    }
  }
};

}  // namespace

double fclScale(const std::vector<const TriangleMesh*>& meshes, double farthest) {
  Extremes extremes;
  for (const TriangleMesh* mesh : meshes) extremes.add(*mesh);
  extremes.largestCoordinate = std::max(extremes.largestCoordinate, farthest);
  if (!std::isfinite(extremes.smallestArea)) return 1.0;
  const int exponent = -static_cast<int>(std::floor(0.5 * std::ilogb(extremes.smallestArea)));
  return std::ldexp(1.0, std::min(exponent, kLargestExponent - std::ilogb(extremes.largestCoordinate)));
}

double largestCoordinate(const TriangleMesh& mesh) {
  double largest = 0.0;
  for (const Vector3& vertex : mesh.vertices) largest = std::max(largest, vertex.cwiseAbs().maxCoeff());
  return largest;
}

}  // namespace glissade
