#include "engine/environment/point_clearance.h"

#include <algorithm>

namespace glissade {

Vector3 nearestOnTriangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const double d1 = ab.dot(p - a);
  const double d2 = ac.dot(p - a);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const double d3 = ab.dot(p - b);
  const double d4 = ac.dot(p - b);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
  const double d5 = ab.dot(p - c);
  const double d6 = ac.dot(p - c);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double scale = 1.0 / (va + vb + vc);
  return a + vb * scale * ab + vc * scale * ac;
}

PointClearance::PointClearance(const TriangleMesh& mesh_W, const Vector3& about, double reach)
    : about_(about), reach_(reach) {
  for (const auto& [a, b, c] : mesh_W.triangles) {
    const std::array<Vector3, 3> triangle{mesh_W.vertices[a], mesh_W.vertices[b], mesh_W.vertices[c]};
    Box3 box;
    for (const Vector3& corner : triangle) box.extend(corner);
    if (box.exteriorDistance(about) <= 1.5 * reach) triangles_.push_back(triangle);
  }
}

double PointClearance::operator()(const Vector3& p_W) const {
  double least = reach_ * reach_;
  for (const auto& [a, b, c] : triangles_) {
    least = std::min(least, (nearestOnTriangle(p_W, a, b, c) - p_W).squaredNorm());
  }
  return std::sqrt(least);
}

Vector3 PointClearance::widestNear(const Vector3& p_W, double step, const Box3& within) const {
  Vector3 best = p_W;
  double widest = (*this)(best);
  for (double s = step; s > step / 64.0;) {
    bool better = false;
    // Diagonals, too: between two walls at a right angle no axis alone leads uphill.
    for (int direction = 0; direction < 27; ++direction) {
      const Eigen::Vector3i cell(direction / 9 - 1, direction / 3 % 3 - 1, direction % 3 - 1);
      const Vector3 way = cell.cast<double>();
      const Vector3 next = best + s * way;
      if ((next - about_).norm() > reach_ / 2.0 || !within.contains(next)) continue;
      const double clearance = (*this)(next);
      if (clearance <= widest * (1.0 + 1e-9)) continue;
      widest = clearance;
      best = next;
      better = true;
    }
    if (!better) s /= 2.0;
  }
  return best;
}

}  // namespace glissade
