#include "engine/collision/kernel/oriented_box.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <optional>

namespace glissade {
namespace {

OrientedBox boxAlong(const Eigen::Matrix3d& axes, const std::vector<const Triangle*>& triangles) {
  Box3 box;
  for (const Triangle* triangle : triangles) {
    for (const Vector3& corner : *triangle) box.extend(axes.transpose() * corner);
  }
  return {axes * box.center(), axes, 0.5 * box.sizes()};
}

Eigen::Matrix3d principalAxes(const std::vector<const Triangle*>& triangles) {
  Vector3 mean = Vector3::Zero();
  for (const Triangle* triangle : triangles) {
    for (const Vector3& corner : *triangle) mean += corner;
  }
  mean /= 3.0 * static_cast<double>(triangles.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Triangle* triangle : triangles) {
    for (const Vector3& corner : *triangle) covariance += (corner - mean) * (corner - mean).transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
}

/// Along an edge and the normal; nothing where the triangle has no area.
std::optional<Eigen::Matrix3d> axesAlong(const Triangle& triangle, std::size_t edge) {
  const Vector3 along = triangle[(edge + 1) % 3] - triangle[edge];
  const Vector3 normal = along.cross(triangle[(edge + 2) % 3] - triangle[edge]);
  if (normal.squaredNorm() <= 0.0) return std::nullopt;
  Eigen::Matrix3d axes;
  axes.col(0) = along.normalized();
  axes.col(2) = normal.normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0)).normalized();
  return axes;
}

/// Some with the largest areas.
std::vector<const Triangle*> leadingTriangles(std::vector<const Triangle*> triangles) {
  constexpr std::size_t kMost = 8;
  if (triangles.size() <= kMost) return triangles;
  const auto area = [](const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]).squaredNorm(); };
  std::partial_sort(triangles.begin(), triangles.begin() + kMost, triangles.end(),
                    [&](const Triangle* a, const Triangle* b) { return area(*a) > area(*b); });
  triangles.resize(kMost);
  return triangles;
}

}  // namespace

OrientedBox fitBox(const std::vector<const Triangle*>& triangles) {
  OrientedBox best = boxAlong(Eigen::Matrix3d::Identity(), triangles);
  const auto tryAxes = [&](const Eigen::Matrix3d& axes) {
    const OrientedBox box = boxAlong(axes, triangles);
    if (box.surface() < 0.999 * best.surface()) best = box;
  };
  tryAxes(principalAxes(triangles));
  for (const Triangle* triangle : leadingTriangles(triangles)) {
    for (std::size_t edge = 0; edge < 3; ++edge) {
      if (const auto axes = axesAlong(*triangle, edge)) tryAxes(*axes);
    }
  }
  return best;
}

}  // namespace glissade
