#include "engine/planning/coarse/passage_section.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade {

Point2 acrossAxis(int axis, const Vector3& p_W) { return {p_W[(axis + 1) % 3], p_W[(axis + 2) % 3]}; }

Vector3 alongAxis(int axis, double s, const Point2& uv) {
  Vector3 p;
  p[axis] = s;
  p[(axis + 1) % 3] = uv.x();
  p[(axis + 2) % 3] = uv.y();
  return p;
}

namespace {

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The point at which the edge from p to q meets the plane. The ends are taken in one order, so that neighbouring
/// triangles get the same point.
Point2 meeting(int axis, double position, Vector3 p, Vector3 q) {
  if (q[axis] < p[axis]) std::swap(p, q);
  const double t = (position - p[axis]) / (q[axis] - p[axis]);
  return acrossAxis(axis, p + t * (q - p));
}

double squaredDistanceToSegment(const Point2& p, const Point2& a, const Point2& b) {
  const Point2 ab = b - a;
  const double length = ab.squaredNorm();
  const double t = length > 0.0 ? std::clamp((p - a).dot(ab) / length, 0.0, 1.0) : 0.0;
  return (p - a - t * ab).squaredNorm();
}

}  // namespace

PassageSection::PassageSection(const TriangleMesh& statics_W, int axis, const std::vector<double>& positions,
                               const Point2& about, double reach)
    : reach_(reach) {
  for (const double position : positions) {
    Plane plane;
    bool near = false;
    for (const auto& indices : statics_W.triangles) {
      std::vector<Point2> ends;
      const std::array<Vector3, 3> t{statics_W.vertices[indices[0]], statics_W.vertices[indices[1]],
                                     statics_W.vertices[indices[2]]};
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector3& p = t[i];
        const Vector3& q = t[(i + 1) % 3];
        if ((p[axis] < position) != (q[axis] < position)) ends.push_back(meeting(axis, position, p, q));
      }
      if (ends.size() != 2) continue;
      const Point2 outward = acrossAxis(axis, (t[1] - t[0]).cross(t[2] - t[0]));
      if (cross(ends[1] - ends[0], outward) > 0.0) std::swap(ends[0], ends[1]);
      plane.push_back({ends[0], ends[1]});
      near = near || std::sqrt(squaredDistanceToSegment(about, ends[0], ends[1])) < reach;
    }
    if (near) planes_.push_back(std::move(plane));
  }
}

double PassageSection::signedDistance(const Plane& plane, const Point2& uv) {
  double squared = std::numeric_limits<double>::max();
  int winding = 0;
  for (const auto& [a, b] : plane) {
    squared = std::min(squared, squaredDistanceToSegment(uv, a, b));
    if ((a.y() <= uv.y()) == (b.y() <= uv.y())) continue;
    const double x = a.x() + (uv.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (x > uv.x()) winding += b.y() > a.y() ? 1 : -1;
  }
  const double distance = std::sqrt(squared);
  return winding != 0 ? -distance : distance;
}

double PassageSection::signedDistance(const Point2& uv) const {
  double least = reach_;
  for (const Plane& plane : planes_) least = std::min(least, signedDistance(plane, uv));
  return least;
}

SampledSection::SampledSection(const PassageSection& section, const Eigen::AlignedBox2d& box, int points)
    : box_(box), points_(points), step_(box.sizes() / (points - 1)) {
  values_.reserve(static_cast<std::size_t>(points) * static_cast<std::size_t>(points));
  for (int i = 0; i < points; ++i) {
    for (int j = 0; j < points; ++j) {
      values_.push_back(section.signedDistance(box.min() + Point2(i * step_.x(), j * step_.y())));
    }
  }
}

double SampledSection::signedDistance(const Point2& uv) const {
  const Point2 scaled = (uv - box_.min()).cwiseQuotient(step_).cwiseMax(0.0).cwiseMin(points_ - 1.0);
  const int i = std::min(points_ - 2, static_cast<int>(scaled.x()));
  const int j = std::min(points_ - 2, static_cast<int>(scaled.y()));
  const double s = scaled.x() - i;
  const double t = scaled.y() - j;
  const auto value = [&](int a, int b) { return values_[static_cast<std::size_t>(a) * points_ + b]; };
  return (1 - s) * ((1 - t) * value(i, j) + t * value(i, j + 1)) +
         s * ((1 - t) * value(i + 1, j) + t * value(i + 1, j + 1));
}

std::vector<Point2> pointsAlong(const std::vector<Point2>& outline, double spacing) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point2& a = outline[i];
    const Point2& b = outline[(i + 1) % outline.size()];
    const int pieces = std::max(1, static_cast<int>(std::ceil((b - a).norm() / spacing)));
    for (int k = 0; k < pieces; ++k) points.push_back(a + (b - a) * k / pieces);
  }
  return points;
}

std::vector<Point2> convexHull(std::vector<Point2> points) {
  std::sort(points.begin(), points.end(),
            [](const Point2& a, const Point2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point2> hull;
  const auto addAll = [&](auto begin, auto end) {
    const std::size_t base = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= base + 2 && cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(*p);
    }
    hull.pop_back();
  };
  addAll(points.begin(), points.end());
  addAll(points.rbegin(), points.rend());
  return hull;
}

}  // namespace glissade
