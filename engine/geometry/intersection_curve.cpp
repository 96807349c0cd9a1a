#include "engine/geometry/intersection_curve.h"

#include <algorithm>
#include <array>
#include <optional>

#include "engine/geometry/triangle_tree.h"

namespace glissade {
namespace {

/// A part of a line: origin + t * direction for t from `from` to `to`.
struct LineSpan {
  double from = 0.0;
  double to = 0.0;
};

/// The part of a line in the triangle's plane that is inside the triangle.
std::optional<LineSpan> spanInside(const Triangle& triangle, const std::array<double, 3>& heights,
                                   const Vector3& origin, const Vector3& direction) {
  std::array<double, 6> places{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if ((heights[i] < 0.0) == (heights[next] < 0.0)) continue;
    const double share = heights[i] / (heights[i] - heights[next]);
    places[count++] = (triangle[i] + share * (triangle[next] - triangle[i]) - origin).dot(direction);
  }
  if (count < 2) return std::nullopt;
  return LineSpan{std::min(places[0], places[1]), std::max(places[0], places[1])};
}

struct CornerHeights {
  Vector3 normal;
  std::array<double, 3> heights;  ///< heights of the other triangle's corners above this triangle's plane
};

CornerHeights heightsAbove(const Triangle& plane, const Triangle& other) {
  CornerHeights sided;
  sided.normal = (plane[1] - plane[0]).cross(plane[2] - plane[0]).stableNormalized();
  for (std::size_t i = 0; i < 3; ++i) sided.heights[i] = sided.normal.dot(other[i] - plane[0]);
  return sided;
}

std::optional<std::array<Vector3, 2>> cutOf(const Triangle& a, const Triangle& b) {
  const CornerHeights ofA = heightsAbove(a, b);
  const CornerHeights ofB = heightsAbove(b, a);
  const Vector3 along = ofA.normal.cross(ofB.normal);
  constexpr double kParallel = 1e-9;
  if (along.norm() < kParallel) return std::nullopt;
  const Vector3 direction = along.normalized();
  const auto inB = spanInside(b, ofA.heights, Vector3::Zero(), direction);
  const auto inA = spanInside(a, ofB.heights, Vector3::Zero(), direction);
  if (!inA || !inB) return std::nullopt;
  const LineSpan both{std::max(inA->from, inB->from), std::min(inA->to, inB->to)};
  if (both.from > both.to) return std::nullopt;
  // A point of the common line lies on an edge of b that crosses the plane of a.
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if ((ofA.heights[i] < 0.0) == (ofA.heights[next] < 0.0)) continue;
    const double share = ofA.heights[i] / (ofA.heights[i] - ofA.heights[next]);
    const Vector3 p = b[i] + share * (b[next] - b[i]);
    const Vector3 origin = p - p.dot(direction) * direction;
    return std::array<Vector3, 2>{origin + both.from * direction, origin + both.to * direction};
  }
  return std::nullopt;
}

}  // namespace

std::vector<Vector3> intersectionCurve(const TriangleMesh& a, const Pose& X_WA, const TriangleMesh& b, const Pose& X_WB,
                                       std::size_t mostSegments) {
  const TriangleTree treeA(transformed(a, X_WA));
  const TriangleTree treeB(transformed(b, X_WB));
  std::vector<Vector3> ends;
  treeA.visitPairs(treeB, 0.0, [&](std::uint32_t i, std::uint32_t j) {
    if (const auto cut = cutOf(treeA.triangles()[i], treeB.triangles()[j])) {
      ends.insert(ends.end(), cut->begin(), cut->end());
    }
    return ends.size() < 2 * mostSegments;
  });
  return ends;
}

}  // namespace glissade
