#include "engine/fits/giving_way.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

/// Mean square distance of the surface from its centre, square metres.
double meanSquareSize(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return 0.0;
  const Vector3 origin = mesh.vertices.front();  // near the surface, for less rounding
  double area = 0.0;
  double square = 0.0;
  Vector3 first = Vector3::Zero();
  for (const auto& triangle : mesh.triangles) {
    const Vector3 a = mesh.vertices[triangle[0]] - origin;
    const Vector3 b = mesh.vertices[triangle[1]] - origin;
    const Vector3 c = mesh.vertices[triangle[2]] - origin;
    const Vector3 sum = a + b + c;
    const double own = 0.5 * (b - a).cross(c - a).norm();
    area += own;
    first += own / 3.0 * sum;
    square += own / 12.0 * (a.squaredNorm() + b.squaredNorm() + c.squaredNorm() + sum.squaredNorm());
  }
  return area > 0.0 ? square / area - (first / area).squaredNorm() : 0.0;
}

}  // namespace

bool givesWayFirst(const RigidBody& body, const RigidBody& other) {
  constexpr double kAlike = 1e-6;
  const double own = meanSquareSize(*body.mesh);
  const double others = meanSquareSize(*other.mesh);
  if (std::abs(own - others) <= kAlike * std::max(own, others)) return body.id < other.id;
  return own < others;
}

}  // namespace glissade
