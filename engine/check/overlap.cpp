#include "engine/check/overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/check/deepest_points.h"
#include "engine/geometry/triangle_crossing.h"

namespace glissade::check {
namespace {

constexpr double kLeastDepth = 1e-7;  ///< metres: what rounding of coordinates can be
constexpr int kMostWidenings = 8;

class DepthSearch {
 public:
  DepthSearch(const PlacedBody& body, const PlacedBody& other) : body_(body), other_(other) {
    overlap_.depths.assign(body.regions.count, 0.0);
  }

  Overlap search(const StopToken& stop) {
    other_.tree.visit(body_.tree.box(), [&](std::uint32_t t) {
      meetTriangle(t);
      return !stop.stopRequested();
    });
    for (double& depth : overlap_.depths) depth = depth > kLeastDepth ? depth : 0.0;
    if (overlap_.deepest > kLeastDepth) {
      findThickness();
    } else {
      overlap_.deepest = 0.0;
    }
    return std::move(overlap_);
  }

 private:
  /// Triangles of the body that can be nearest to a point of the part are no farther from it than it is deep.
  void meetTriangle(std::uint32_t number) {
    const Triangle& part = other_.tree.triangles()[number];
    const Vector3& normal = other_.normals[number];
    double deepest = 0.0;
    for (const Vector3& corner : part) deepest = std::max(deepest, meet(corner, normal));
    for (int i = 0; i < kMostWidenings; ++i) {
      const double reach = 2.0 * std::max(deepest, kLeastDepth);
      const std::vector<std::uint32_t> near = trianglesNear(part, reach);
      if (deepest == 0.0 && isOutside(part, normal, near)) return;
      std::vector<Triangle> triangles;
      for (const std::uint32_t t : near) triangles.push_back(body_.tree.triangles()[t]);
      for (const Vector3& p : deepestPoints(part, triangles)) {
        if (!isShallow(p, near, normal)) deepest = std::max(deepest, meet(p, normal));
      }
      if (deepest <= reach) return;
    }
  }

  /// The part does not pass through the surface, and its middle is not inside.
  bool isOutside(const Triangle& part, const Vector3& normal, const std::vector<std::uint32_t>& near) {
    const bool crosses = std::any_of(near.begin(), near.end(), [&](std::uint32_t t) {
      return trianglesCross(part, body_.tree.triangles()[t], kLeastDepth);
    });
    return !crosses && meet((part[0] + part[1] + part[2]) / 3.0, normal) <= kLeastDepth;
  }

  std::vector<std::uint32_t> trianglesNear(const Triangle& part, double reach) const {
    Box3 box(part[0]);
    box.extend(part[1]);
    box.extend(part[2]);
    box.min().array() -= reach;
    box.max().array() += reach;
    std::vector<std::uint32_t> near;
    body_.tree.visit(box, [&](std::uint32_t t) {
      const Triangle& triangle = body_.tree.triangles()[t];
      if (triangleDistance(part, triangle).squared <= reach * reach || trianglesMeet(part, triangle)) {
        near.push_back(t);
      }
      return true;
    });
    return near;
  }

  /// The point is no deeper than what was met below each of the faces that it can count for.
  bool isShallow(const Vector3& p, const std::vector<std::uint32_t>& near, const Vector3& normal) const {
    double met = std::numeric_limits<double>::infinity();
    double distance = std::numeric_limits<double>::infinity();
    for (const std::uint32_t t : near) {
      const double cosine = body_.normals[t].dot(normal);
      if (cosine > -kFacing) continue;
      distance = std::min(distance, (nearestPoint(body_.tree.triangles()[t], p) - p).squaredNorm());
      if (cosine < kFacing) met = std::min(met, overlap_.depths[body_.regions.of[t]]);
    }
    const double enough = std::max(std::isfinite(met) ? met : 0.0, kLeastDepth);
    return distance <= enough * enough;
  }

  /// Depth of a point of the other surface, 0 outside. It counts for the face that is nearest, if that faces it. The
  /// other side of a thin wall, which points the same way as the other surface, is passed over.
  double meet(const Vector3& p, const Vector3& normal) {
    if (!body_.tree.box().contains(p) || !body_.contains(p)) return 0.0;
    const TriangleTree::Nearest nearest = body_.tree.nearest(p, std::numeric_limits<double>::infinity());
    const bool isOtherSide = body_.normals[nearest.triangle].dot(normal) > -kFacing;
    const TriangleTree::Nearest counted = isOtherSide ? nearestNotBehind(p, normal) : nearest;
    if (body_.normals[counted.triangle].dot(normal) < kFacing) {
      double& depth = overlap_.depths[body_.regions.of[counted.triangle]];
      depth = std::max(depth, counted.distance);
    }
    if (nearest.distance > overlap_.deepest) {
      overlap_.deepest = nearest.distance;
      deepest_ = p;
      triangle_ = nearest.triangle;
    }
    return nearest.distance;
  }

  /// The nearest triangle within the largest overlap that is no clash, of those that do not point along the normal; any
  /// triangle that does where there is none.
  TriangleTree::Nearest nearestNotBehind(const Vector3& p, const Vector3& normal) const {
    TriangleTree::Nearest nearest = body_.tree.nearest(p, std::numeric_limits<double>::infinity());
    double least = kClashOverlap * kClashOverlap;
    const Vector3 reach = Vector3::Constant(kClashOverlap);
    body_.tree.visit(Box3(p - reach, p + reach), [&](std::uint32_t t) {
      if (body_.normals[t].dot(normal) > -kFacing) return true;
      const double squared = (nearestPoint(body_.tree.triangles()[t], p) - p).squaredNorm();
      if (squared < least) nearest = {std::sqrt(squared), t};
      least = std::min(least, squared);
      return true;
    });
    return nearest;
  }

  void findThickness() {
    const Vector3 inwards = -body_.normals[triangle_];
    const Vector3 surface = nearestPoint(body_.tree.triangles()[triangle_], deepest_);
    overlap_.thickness = body_.tree.firstHit(surface, inwards, 1e-9 * body_.tree.box().diagonal().norm());
  }

  const PlacedBody& body_;
  const PlacedBody& other_;
  Overlap overlap_;
  Vector3 deepest_ = Vector3::Zero();
  std::uint32_t triangle_ = 0;
};

}  // namespace

Overlap overlapIn(const PlacedBody& body, const PlacedBody& other, const StopToken& stop) {
  if (!body.interior || !body.tree.box().intersects(other.tree.box())) {
    return {std::vector<double>(body.regions.count, 0.0), 0.0, 0.0};
  }
  return DepthSearch(body, other).search(stop);
}

}  // namespace glissade::check
