#include "engine/collision/kernel/oriented_box.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <optional>

namespace glissade {
namespace {

/// The box along these axes, unless its surface is `most` or more: with those that stick out farthest first,
/// few triangles are looked at to know.
std::optional<OrientedBox> boxAlong(const Eigen::Matrix3d& axes, const std::vector<const Triangle*>& triangles,
                                    double most = std::numeric_limits<double>::infinity()) {
  Box3 corners;
  OrientedBox box;
  box.axes = axes;
  for (const Triangle* triangle : triangles) {
    for (const Vector3& corner : *triangle) corners.extend(axes.transpose() * corner);
    box.half = 0.5 * corners.sizes();
    if (box.surface() >= most) return std::nullopt;
  }
  box.centre = axes * corners.center();
  return box;
}

/// First those that reach farthest along the coordinate axes and the diagonals of a cube.
std::vector<const Triangle*> outermostFirst(std::vector<const Triangle*> triangles) {
  const std::array<Vector3, 7> directions{Vector3(1, 0, 0),  Vector3(0, 1, 0),  Vector3(0, 0, 1), Vector3(1, 1, 1),
                                          Vector3(1, 1, -1), Vector3(1, -1, 1), Vector3(-1, 1, 1)};
  if (triangles.size() <= 2 * directions.size()) return triangles;
  auto front = triangles.begin();
  for (const Vector3& direction : directions) {
    for (const double sign : {-1.0, 1.0}) {
      const Vector3 along = sign * direction;
      const auto reach = [&](const Triangle* t) {
        return std::max({along.dot((*t)[0]), along.dot((*t)[1]), along.dot((*t)[2])});
      };
      auto farthest = front;
      double most = reach(*front);
      for (auto at = std::next(front); at != triangles.end(); ++at) {
        const double here = reach(*at);
        if (here > most) {
          most = here;
          farthest = at;
        }
      }
      std::iter_swap(front++, farthest);
    }
  }
  return triangles;
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
  const std::vector<const Triangle*> ordered = outermostFirst(triangles);
  OrientedBox best = *boxAlong(Eigen::Matrix3d::Identity(), ordered);
  const auto tryAxes = [&](const Eigen::Matrix3d& axes) {
    if (const auto box = boxAlong(axes, ordered, 0.999 * best.surface())) best = *box;
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
