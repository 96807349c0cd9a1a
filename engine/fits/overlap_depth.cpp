#include "engine/fits/overlap_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/mesh_audit.h"

namespace glissade {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
/// Share of the common box's diagonal between two samples.
constexpr double kSpacing = 0.05;
constexpr double kAboveRounding = 1.0 + 1e-9;
/// Distance, in diagonals, below which hits of an inward ray belong to the face where it begins.
constexpr double kSameSurface = 1e-6;

std::vector<Triangle> trianglesOf(const TriangleMesh& mesh) { return TriangleTree(mesh).triangles(); }

/// The part of a convex polygon on one side of a plane across an axis (I. Sutherland, G. Hodgman, 1974).
std::vector<Vector3> clipped(const std::vector<Vector3>& polygon, int axis, double limit, double sign) {
  std::vector<Vector3> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3& from = polygon[i];
    const Vector3& to = polygon[(i + 1) % polygon.size()];
    const double before = sign * (limit - from[axis]);
    const double after = sign * (limit - to[axis]);
    if (before >= 0.0) result.push_back(from);
    if ((before > 0.0 && after < 0.0) || (before < 0.0 && after > 0.0)) {
      result.push_back(from + (to - from) * (before / (before - after)));
    }
  }
  return result;
}

std::vector<Vector3> clipped(const Triangle& triangle, const Box3& box) {
  std::vector<Vector3> polygon(triangle.begin(), triangle.end());
  for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
    polygon = clipped(polygon, axis, box.max()[axis], 1.0);
    polygon = clipped(polygon, axis, box.min()[axis], -1.0);
  }
  return polygon;
}

/// Branch and bound over pieces of triangles: the distance from the body's surface changes by no more than that of two
/// points.
class DepthSearch {
 public:
  DepthSearch(const TriangleTree& body, const SolidDepth& solid, double floor)
      : body_(body), solid_(solid), deepest_{floor, 0} {}

  /// `near`: a point within `distance` of the body's surface.
  void search(const Triangle& piece, double spacing, const Vector3& near = Vector3::Zero(),
              double distance = kUnbounded) {
    const Vector3 middle = (piece[0] + piece[1] + piece[2]) / 3.0;
    double radius = 0.0;
    for (const Vector3& corner : piece) radius = std::max(radius, (corner - middle).norm());
    const bool inside = solid_.contains(middle);
    const double most = inside ? boundAt(middle, near, distance) : radius;
    const double uninteresting = std::max(0.0, deepest_.depth - radius) / kAboveRounding;
    const TriangleTree::Nearest nearest = body_.nearest(middle, most, uninteresting);
    if (nearest.distance + radius <= deepest_.depth || (!inside && nearest.distance >= radius)) return;
    if (inside) take(nearest);
    if (radius <= spacing) {
      for (const Vector3& corner : piece) {
        if (solid_.contains(corner)) take(body_.nearest(corner, boundAt(corner, middle, nearest.distance)));
      }
      return;
    }
    const Vector3 ab = 0.5 * (piece[0] + piece[1]);
    const Vector3 bc = 0.5 * (piece[1] + piece[2]);
    const Vector3 ca = 0.5 * (piece[2] + piece[0]);
    search({piece[0], ab, ca}, spacing, middle, nearest.distance);
    search({ab, piece[1], bc}, spacing, middle, nearest.distance);
    search({ca, bc, piece[2]}, spacing, middle, nearest.distance);
    search({ab, bc, ca}, spacing, middle, nearest.distance);
  }

  std::optional<OverlapDepth> deepest() const { return found_ ? std::optional(deepest_) : std::nullopt; }

 private:
  /// Upper bound on the distance of `p` from the surface.
  static double boundAt(const Vector3& p, const Vector3& near, double distance) {
    return kAboveRounding * (distance + (p - near).norm());
  }

  void take(const TriangleTree::Nearest& nearest) {
    if (nearest.distance <= deepest_.depth) return;
    deepest_ = {nearest.distance, nearest.triangle};
    found_ = true;
  }

  const TriangleTree& body_;
  const SolidDepth& solid_;
  OverlapDepth deepest_;
  bool found_ = false;
};

}  // namespace

std::optional<SolidDepth> SolidDepth::of(const TriangleMesh& mesh_W) {
  const MeshAudit result = audit(mesh_W);
  if (!result.closed()) return std::nullopt;
  return SolidDepth(mesh_W, result.consistentlyOriented, result.volume < 0.0 ? -1.0 : 1.0);
}

SolidDepth::SolidDepth(const TriangleMesh& mesh_W, bool oriented, double sense)
    : interior_(mesh_W, oriented),
      rays_(trianglesOf(mesh_W)),
      sense_(sense),
      beyond_(kSameSurface * boundingBox(mesh_W).diagonal().norm()) {}

double SolidDepth::thicknessBelow(const Triangle& triangle) const {
  const Vector3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).stableNormalized();
  const Vector3 middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
  return normal.isZero(0.0) ? kUnbounded : rays_.firstHit(middle, -sense_ * normal, beyond_);
}

std::optional<OverlapDepth> depthInside(const TriangleTree& surface, const TriangleTree& body, const SolidDepth& solid,
                                        double floor, const std::function<bool(std::uint32_t)>& isCoincident) {
  const Box3 common = surface.box().intersection(body.box());
  if (common.isEmpty()) return std::nullopt;
  DepthSearch depths(body, solid, floor);
  const double spacing = kSpacing * common.diagonal().norm();
  surface.visit(common, [&](std::uint32_t t) {
    const std::vector<Vector3> polygon = clipped(surface.triangles()[t], common);
    const double ofTriangle = isCoincident(t) ? kUnbounded : spacing;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      depths.search({polygon[0], polygon[i], polygon[i + 1]}, ofTriangle);
    }
    return true;
  });
  return depths.deepest();
}

}  // namespace glissade
