#include "engine/collision/kernel/oriented_box.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <optional>

namespace glissade {
namespace {

/// The box along these axes; nothing if its surface is `most` or more. If the outermost triangles come first, few
/// triangles decide that.
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

/// The triangles that reach farthest along the coordinate axes and the diagonals of a cube come first.
std::vector<const Triangle*> outermostFirst(std::vector<const Triangle*> triangles) {
  constexpr std::size_t kDirections = 7;
  if (triangles.size() <= 2 * kDirections) return triangles;
  const auto alongEach = [](const Vector3& p) {
    return std::array<double, kDirections>{p.x(),
                                           p.y(),
                                           p.z(),
                                           p.x() + p.y() + p.z(),
                                           p.x() + p.y() - p.z(),
                                           p.x() - p.y() + p.z(),
                                           p.y() + p.z() - p.x()};
  };
  struct Outermost {
    double reach = -std::numeric_limits<double>::infinity();
    std::size_t triangle = 0;
  };
  std::array<Outermost, 2 * kDirections> outermost;
  const auto take = [](Outermost& known, double reach, std::size_t triangle) {
    if (reach > known.reach) known = {reach, triangle};
  };
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto a = alongEach((*triangles[i])[0]);
    const auto b = alongEach((*triangles[i])[1]);
    const auto c = alongEach((*triangles[i])[2]);
    for (std::size_t k = 0; k < kDirections; ++k) {
      take(outermost[2 * k], std::max(std::max(a[k], b[k]), c[k]), i);
      take(outermost[2 * k + 1], -std::min(std::min(a[k], b[k]), c[k]), i);
    }
  }
  std::array<std::size_t, 2 * kDirections> found;
  std::transform(outermost.begin(), outermost.end(), found.begin(), [](const Outermost& o) { return o.triangle; });
  // In ascending order no triangle is swapped away before its turn.
  std::sort(found.begin(), found.end());
  const auto last = std::unique(found.begin(), found.end());
  for (auto at = found.begin(); at != last; ++at) {
    std::swap(triangles[static_cast<std::size_t>(at - found.begin())], triangles[*at]);
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

/// Axes along an edge and the normal; nothing where the triangle has no area.
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

/// At most `most` triangles with the largest areas, the largest first.
std::vector<const Triangle*> leadingTriangles(const std::vector<const Triangle*>& triangles, std::size_t most) {
  if (triangles.size() <= most) return triangles;
  struct Sized {
    double squaredArea;
    const Triangle* triangle;
  };
  std::vector<Sized> sized;
  sized.reserve(triangles.size());
  for (const Triangle* t : triangles) {
    sized.push_back({((*t)[1] - (*t)[0]).cross((*t)[2] - (*t)[0]).squaredNorm(), t});
  }
  const auto last = sized.begin() + static_cast<std::ptrdiff_t>(most);
  std::partial_sort(sized.begin(), last, sized.end(),
                    [](const Sized& a, const Sized& b) { return a.squaredArea > b.squaredArea; });
  std::vector<const Triangle*> leading;
  std::transform(sized.begin(), last, std::back_inserter(leading), [](const Sized& s) { return s.triangle; });
  return leading;
}

/// The smallest of the boxes along the coordinate axes, the principal axes, and the edges of some large triangles.
OrientedBox smallestBox(const std::vector<const Triangle*>& triangles, const std::vector<const Triangle*>& ordered,
                        std::size_t mostLeading) {
  OrientedBox best = *boxAlong(Eigen::Matrix3d::Identity(), ordered);
  const auto tryAxes = [&](const Eigen::Matrix3d& axes) {
    if (const auto box = boxAlong(axes, ordered, 0.999 * best.surface())) best = *box;
  };
  tryAxes(principalAxes(triangles));
  for (const Triangle* triangle : leadingTriangles(triangles, mostLeading)) {
    for (std::size_t edge = 0; edge < 3; ++edge) {
      if (const auto axes = axesAlong(*triangle, edge)) tryAxes(*axes);
    }
  }
  return best;
}

}  // namespace

OrientedBox fitBox(const std::vector<const Triangle*>& triangles) {
  constexpr std::size_t kLeading = 8;
  return smallestBox(triangles, outermostFirst(triangles), kLeading);
}

OrientedBox fitBoxQuickly(const std::vector<const Triangle*>& triangles) {
  constexpr std::size_t kMostFitted = 512;
  if (triangles.size() > kMostFitted) return *boxAlong(Eigen::Matrix3d::Identity(), triangles);
  return smallestBox(triangles, triangles, 1);
}

}  // namespace glissade
