#include "engine/import/formats/polygon_triangulation.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace glissade {
namespace {

using Point = Eigen::Vector2d;

/// Twice the signed area.
double area(const Point& a, const Point& b, const Point& c) {
  const Point ab = b - a;
  const Point ac = c - a;
  return ab.x() * ac.y() - ab.y() * ac.x();
}

/// Newell's normal; its length is twice the area.
Vector3 normalOf(const std::vector<Vector3>& corners) {
  Vector3 normal = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
  }
  return normal;
}

/// The corners projected along the normal's largest coordinate, counter-clockwise.
std::vector<Point> projected(const std::vector<Vector3>& corners, const Vector3& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const Eigen::Index right = (axis + 1) % 3;
  const Eigen::Index up = (axis + 2) % 3;
  const bool seenFromBehind = normal[axis] < 0.0;
  std::vector<Point> points;
  for (const Vector3& corner : corners) {
    const Vector3 p = corner - corners[0];
    points.push_back(seenFromBehind ? Point(p[up], p[right]) : Point(p[right], p[up]));
  }
  return points;
}

bool fanCovers(const std::vector<Point>& points) {
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (area(points[0], points[i], points[i + 1]) < 0.0) return false;
  }
  return true;
}

std::vector<TriangleIndices> fanOf(std::size_t corners) {
  std::vector<TriangleIndices> fan;
  for (std::uint32_t i = 1; i + 1 < corners; ++i) fan.push_back({0, i, i + 1});
  return fan;
}

/// Triangulates a polygon by cutting off ears.
class EarClipping {
 public:
  explicit EarClipping(const std::vector<Point>& points) : points_(points), left_(points.size()) {
    std::iota(left_.begin(), left_.end(), 0U);
  }

  std::optional<std::vector<TriangleIndices>> triangles() && {
    while (left_.size() > 3) {
      const auto ear = findEar();
      if (!ear) return std::nullopt;
      cut(*ear);
    }
    if (area(at(0), at(1), at(2)) < 0.0) return std::nullopt;
    cut(1);
    return std::move(triangles_);
  }

 private:
  const Point& at(std::size_t i) const { return points_[left_[i % left_.size()]]; }

  std::optional<std::size_t> findEar() const {
    std::optional<std::size_t> flat;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const std::size_t ear = (next_ + i) % left_.size();
      const double size = area(at(ear + left_.size() - 1), at(ear), at(ear + 1));
      if (size > 0.0 && isEmpty(ear)) return ear;
      if (size == 0.0 && !flat) flat = ear;
    }
    return flat;  // an ear without area does not change the polygon
  }

  /// True if no other corner is in the ear; corners that coincide with one of its corners do not count.
  bool isEmpty(std::size_t ear) const {
    const Point& a = at(ear + left_.size() - 1);
    const Point& b = at(ear);
    const Point& c = at(ear + 1);
    for (std::size_t i = ear + 2; i < ear + left_.size() - 1; ++i) {
      const Point& p = at(i);
      if (p == a || p == b || p == c) continue;
      if (area(a, b, p) >= 0.0 && area(b, c, p) >= 0.0 && area(c, a, p) >= 0.0) return false;
    }
    return true;
  }

  void cut(std::size_t ear) {
    const std::size_t count = left_.size();
    triangles_.push_back({left_[(ear + count - 1) % count], left_[ear], left_[(ear + 1) % count]});
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
    next_ = ear;
  }

  const std::vector<Point>& points_;
  std::vector<std::uint32_t> left_;  ///< remaining corners, in order
  std::size_t next_ = 0;             ///< first corner of the next search
  std::vector<TriangleIndices> triangles_;
};

}  // namespace

std::optional<std::vector<TriangleIndices>> triangulatePolygon(const std::vector<Vector3>& corners) {
  if (corners.size() == 3) return fanOf(3);
  const Vector3 normal = normalOf(corners);
  if (normal.isZero(0.0)) return fanOf(corners.size());
  const std::vector<Point> points = projected(corners, normal);
  return fanCovers(points) ? fanOf(corners.size()) : EarClipping(points).triangles();
}

}  // namespace glissade
