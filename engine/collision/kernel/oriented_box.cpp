#include "engine/collision/kernel/oriented_box.h"

#include <Eigen/Eigenvalues>
#include <array>

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

/// Identity where no triangle has an area.
Eigen::Matrix3d axesOfLargestTriangle(const std::vector<const Triangle*>& triangles) {
  double largest = 0.0;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  for (const Triangle* triangle : triangles) {
    const auto& [a, b, c] = *triangle;
    const Vector3 normal = (b - a).cross(c - a);
    if (normal.squaredNorm() <= largest) continue;
    largest = normal.squaredNorm();
    Vector3 edge = b - a;
    for (const Vector3& other : {Vector3(c - b), Vector3(a - c)}) {
      if (other.squaredNorm() > edge.squaredNorm()) edge = other;
    }
    axes.col(0) = edge.normalized();
    axes.col(2) = normal.normalized();
    axes.col(1) = axes.col(2).cross(axes.col(0)).normalized();
  }
  return axes;
}

}  // namespace

OrientedBox fitBox(const std::vector<const Triangle*>& triangles) {
  OrientedBox best = boxAlong(Eigen::Matrix3d::Identity(), triangles);
  for (const Eigen::Matrix3d& axes : {principalAxes(triangles), axesOfLargestTriangle(triangles)}) {
    const OrientedBox box = boxAlong(axes, triangles);
    if (box.surface() < 0.999 * best.surface()) best = box;
  }
  return best;
}

}  // namespace glissade
