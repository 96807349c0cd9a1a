#include "tests/engine/collision/exact_reference.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <limits>

namespace glissade::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

Point toCgal(const Vector3& p) { return {p.x(), p.y(), p.z()}; }

Kernel::Triangle_3 triangleOf(const TriangleMesh& mesh, const TriangleIndices& t) {
  return {toCgal(mesh.vertices[t[0]]), toCgal(mesh.vertices[t[1]]), toCgal(mesh.vertices[t[2]])};
}

bool surfacesMeet(const TriangleMesh& a, const TriangleMesh& b) {
  for (const auto& s : a.triangles) {
    const auto first = triangleOf(a, s);
    for (const auto& t : b.triangles) {
      if (CGAL::do_intersect(first, triangleOf(b, t))) return true;
    }
  }
  return false;
}

/// Parity of the crossings of a segment to a far point in a direction that hits no edge by accident.
bool isInside(const TriangleMesh& solid, const Vector3& p) {
  const Vector3 far = p + 1e4 * Vector3(0.5371, 0.6127, 0.5797);
  const Kernel::Segment_3 ray(toCgal(p), toCgal(far));
  int crossings = 0;
  for (const auto& t : solid.triangles) crossings += CGAL::do_intersect(ray, triangleOf(solid, t)) ? 1 : 0;
  return crossings % 2 == 1;
}

double pointTriangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 n = (b - a).cross(c - a);
  const auto onInnerSide = [&](const Vector3& u, const Vector3& v) { return n.cross(v - u).dot(p - u) >= 0.0; };
  if (onInnerSide(a, b) && onInnerSide(b, c) && onInnerSide(c, a)) return std::abs(n.normalized().dot(p - a));
  const auto toSegment = [&](const Vector3& u, const Vector3& v) {
    const double t = std::clamp((p - u).dot(v - u) / (v - u).squaredNorm(), 0.0, 1.0);
    return (p - (u + t * (v - u))).norm();
  };
  return std::min({toSegment(a, b), toSegment(b, c), toSegment(c, a)});
}

double segmentSegment(const Vector3& p, const Vector3& q, const Vector3& r, const Vector3& s) {
  const Vector3 u = q - p;
  const Vector3 v = s - r;
  const Vector3 w = p - r;
  const double a = u.dot(u);
  const double b = u.dot(v);
  const double c = v.dot(v);
  const double det = a * c - b * b;
  double t = det > 1e-14 * a * c ? std::clamp((b * v.dot(w) - c * u.dot(w)) / det, 0.0, 1.0) : 0.0;
  const double k = std::clamp((t * b + v.dot(w)) / c, 0.0, 1.0);
  t = std::clamp((k * b - u.dot(w)) / a, 0.0, 1.0);
  return ((p + t * u) - (r + k * v)).norm();
}

double triangleTriangle(const std::array<Vector3, 3>& a, const std::array<Vector3, 3>& b) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    best = std::min({best, pointTriangle(a[i], b[0], b[1], b[2]), pointTriangle(b[i], a[0], a[1], a[2])});
    for (std::size_t j = 0; j < 3; ++j) {
      best = std::min(best, segmentSegment(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
    }
  }
  return best;
}

std::array<Vector3, 3> corners(const TriangleMesh& mesh, const TriangleIndices& t) {
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

}  // namespace

bool collides(const std::vector<RigidBody>& obstacles, const TriangleMesh& object, const Pose& X_WB) {
  const TriangleMesh placed = transformed(object, X_WB);
  for (const RigidBody& body : obstacles) {
    const TriangleMesh obstacle = transformed(*body.mesh, body.X_WB);
    if (surfacesMeet(obstacle, placed)) return true;
    if (isInside(obstacle, placed.vertices.front()) || isInside(placed, obstacle.vertices.front())) return true;
  }
  return false;
}

double surfaceDistance(const std::vector<RigidBody>& obstacles, const TriangleMesh& object, const Pose& X_WB) {
  const TriangleMesh placed = transformed(object, X_WB);
  double best = std::numeric_limits<double>::infinity();
  for (const RigidBody& body : obstacles) {
    const TriangleMesh obstacle = transformed(*body.mesh, body.X_WB);
    for (const auto& s : obstacle.triangles) {
      for (const auto& t : placed.triangles) {
        best = std::min(best, triangleTriangle(corners(obstacle, s), corners(placed, t)));
      }
    }
  }
  return best;
}

double pointDistance(const TriangleMesh& surface, const Vector3& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& t : surface.triangles) {
    const auto [a, b, c] = corners(surface, t);
    best = std::min(best, pointTriangle(p, a, b, c));
  }
  return best;
}

}  // namespace glissade::reference
