#include "engine/evidence/overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/evidence/deepest_points.h"
#include "engine/evidence/part_cells.h"
#include "engine/geometry/triangle_crossing.h"
#include "engine/geometry/vertex_welder.h"

namespace glissade::evidence {
namespace {

constexpr double kLeastDepth = 1e-7;    ///< metres: rounding of coordinates
constexpr double kSameDistance = 1e-9;  ///< metres: smaller differences of distances count as equal
constexpr int kMostWidenings = 16;
/// If more triangles than kManyTriangles are near a part, not all are compared: a clash is only deepened, and any other
/// part is cut into cells, down to kFinestShare of the largest depth, unless it is in a thin wall.
constexpr std::size_t kManyTriangles = 256;
constexpr double kFinestShare = 0.01;
/// The largest depth of such a clash is found up to this factor.
constexpr double kEnough = 1.01;
/// Number of points between two checks of the stop token.
constexpr std::size_t kPointsBetweenStops = 64;
/// Metres: first search distance for the other face of a wall; it is doubled until one is found.
constexpr double kFirstReach = kClashOverlap / 32.0;
/// Least cosine between the way from one face of a wall to the other and the inward normal of the first face.
constexpr double kStraightThrough = 0.7;

/// Divides the triangle at the middle of its longest edge.
void halve(const Triangle& triangle, std::vector<Triangle>& open) {
  std::size_t longest = 0;
  const auto lengthOf = [&](std::size_t edge) { return (triangle[(edge + 1) % 3] - triangle[edge]).squaredNorm(); };
  for (const std::size_t edge : {1, 2}) longest = lengthOf(edge) > lengthOf(longest) ? edge : longest;
  const Vector3& a = triangle[longest];
  const Vector3& b = triangle[(longest + 1) % 3];
  const Vector3& c = triangle[(longest + 2) % 3];
  const Vector3 middle = 0.5 * (a + b);
  open.push_back({a, middle, c});
  open.push_back({middle, b, c});
}

class DepthSearch {
 public:
  DepthSearch(const PlacedBody& body, const PlacedBody& other) : body_(body), other_(other) {
    overlap_.depths.assign(body.regions.count, 0.0);
  }

  Overlap search(const StopToken& stop) {
    other_.tree.visit(body_.tree.box(), [&](std::uint32_t t) {
      meetTriangle(t, stop);
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
  /// Triangles of the body that can be nearest to a point of the part are within its depth. For a clash with a fine
  /// mesh, not all points are measured for the depths of faces: a depth that is not measured is not allowed.
  void meetTriangle(std::uint32_t number, const StopToken& stop) {
    const Triangle& part = other_.tree.triangles()[number];
    const Vector3& normal = other_.normals[number];
    double deepest = 0.0;
    for (const Vector3& corner : part) deepest = std::max(deepest, meet(corner, normal));
    for (int i = 0; i < kMostWidenings; ++i) {
      const double reach = 2.0 * std::max(deepest, kLeastDepth);
      const std::vector<std::uint32_t> near = trianglesNear(part, reach);
      if (deepest > kClashOverlap && near.size() > kManyTriangles) return deepen(part, stop);
      if (deepest == 0.0 && isOutside(part, normal, near)) return;
      if (isKnown(near, normal, deepest + longestEdge(part))) return;
      const bool many = near.size() > kManyTriangles && !isInWall(near, normal);
      deepest = std::max(
          deepest, many ? deepestInCells(part, normal, {near, reach}, stop) : deepestOf(part, normal, near, stop));
      if (deepest <= reach || stop.stopRequested()) return;
    }
  }

  /// Finds the largest depth of the part to one per cent, without its face. Over a piece of the part the depth grows by
  /// no more than the distance of its points, and the distance from one triangle of the surface is largest at a corner.
  void deepen(const Triangle& part, const StopToken& stop) {
    std::vector<Triangle> open{part};
    while (!open.empty() && !stop.stopRequested()) {
      const Triangle piece = open.back();
      open.pop_back();
      const Vector3 middle = (piece[0] + piece[1] + piece[2]) / 3.0;
      double radius = 0.0;
      for (const Vector3& corner : piece) radius = std::max(radius, (corner - middle).norm());
      const double enough = kEnough * overlap_.deepest;
      const auto nearest =
          body_.tree.nearest(middle, std::numeric_limits<double>::infinity(), std::max(0.0, enough - radius));
      if (nearest.distance + radius <= enough) continue;
      const bool inside = body_.tree.box().contains(middle) && body_.contains(middle);
      if (!inside && nearest.distance >= radius) continue;
      if (inside) takeDeepest(middle, nearest);
      double atCorners = 0.0;
      for (const Vector3& corner : piece) {
        const Vector3 foot = nearestPoint(body_.tree.triangles()[nearest.triangle], corner);
        atCorners = std::max(atCorners, (foot - corner).norm());
      }
      if (atCorners > kEnough * overlap_.deepest + kLeastDepth) halve(piece, open);
    }
  }

  void takeDeepest(const Vector3& p, const TriangleTree::Nearest& nearest) {
    if (nearest.distance <= overlap_.deepest) return;
    overlap_.deepest = nearest.distance;
    deepest_ = p;
    triangle_ = nearest.triangle;
  }

  double deepestOf(const Triangle& part, const Vector3& normal, const std::vector<std::uint32_t>& near,
                   const StopToken& stop) {
    std::vector<Triangle> triangles;
    for (const std::uint32_t t : near) triangles.push_back(body_.tree.triangles()[t]);
    const std::vector<Vector3> points = deepestPoints(part, triangles);
    const std::vector<std::uint32_t> regions = facing(near, normal);
    double deepest = 0.0;
    double met = metBelow(regions);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i % kPointsBetweenStops == 0 && stop.stopRequested()) break;
      if (isNearer(points[i], met, near, normal)) continue;
      deepest = std::max(deepest, meet(points[i], normal));
      met = metBelow(regions);
    }
    return deepest;
  }

  /// Triangles of the body that are this near to a part.
  struct Near {
    const std::vector<std::uint32_t>& triangles;
    double reach;
  };

  /// The largest depth for a fine mesh, up to a share of it. Ends at a point deeper than the reach: another triangle
  /// may be nearer there, so the bounds of the cells do not hold.
  double deepestInCells(const Triangle& part, const Vector3& normal, const Near& near, const StopToken& stop) {
    double deepest = 0.0;
    PartCells cells(part, body_.tree.triangles(), body_.normals, near.triangles);
    while (!cells.empty() && deepest <= near.reach && !stop.stopRequested()) {
      const PartCell cell = cells.take();
      const bool inside = body_.tree.box().contains(cell.middle) && body_.contains(cell.middle);
      const double most = inside ? cell.bound : std::min(cell.bound, cell.radius - cell.distance);
      if (most <= kLeastDepth) continue;
      if (inside && !isKnown(cell.near, normal, cell.distance)) deepest = std::max(deepest, meet(cell.middle, normal));
      const double finest = std::max(kLeastDepth, kFinestShare * overlap_.deepest);
      if (cell.radius > finest && !isKnown(cell.near, normal, most - finest)) cells.halve(cell);
    }
    return deepest;
  }

  /// True if one of the triangles is the other side of a thin wall.
  bool isInWall(const std::vector<std::uint32_t>& near, const Vector3& normal) const {
    return std::any_of(near.begin(), near.end(),
                       [&](std::uint32_t t) { return body_.normals[t].dot(normal) > -kFacing; });
  }

  /// True if a point of this depth, with these nearest triangles, cannot increase a depth.
  bool isKnown(const std::vector<std::uint32_t>& near, const Vector3& normal, double depth) const {
    if (depth > overlap_.deepest) return false;
    return std::all_of(near.begin(), near.end(), [&](std::uint32_t t) {
      if (isFacing(t, normal)) return depth <= overlap_.depths[body_.regions.of[t]];
      return body_.normals[t].dot(normal) <= -kFacing;
    });
  }

  /// True if the part does not cross the surface, and its centre is not inside.
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
    std::sort(near.begin(), near.end());
    return near;
  }

  /// The regions for which points of the part can count, ascending.
  std::vector<std::uint32_t> facing(const std::vector<std::uint32_t>& near, const Vector3& normal) const {
    std::vector<std::uint32_t> regions;
    for (const std::uint32_t t : near) {
      if (isFacing(t, normal)) regions.push_back(body_.regions.of[t]);
    }
    std::sort(regions.begin(), regions.end());
    regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
    return regions;
  }

  double leastMet(const std::vector<std::uint32_t>& regions) const {
    double met = regions.empty() ? 0.0 : std::numeric_limits<double>::infinity();
    for (const std::uint32_t region : regions) met = std::min(met, overlap_.depths[region]);
    return met;
  }

  /// Depth down to which points cannot increase a depth.
  double metBelow(const std::vector<std::uint32_t>& regions) const { return std::max(leastMet(regions), kLeastDepth); }

  /// True if one of the triangles (ascending) that do not point along the normal is within the distance.
  bool isNearer(const Vector3& p, double distance, const std::vector<std::uint32_t>& triangles,
                const Vector3& normal) const {
    bool within = false;
    const Vector3 reach = Vector3::Constant(distance);
    body_.tree.visit(Box3(p - reach, p + reach), [&](std::uint32_t t) {
      if (body_.normals[t].dot(normal) > -kFacing) return true;
      within = (nearestPoint(body_.tree.triangles()[t], p) - p).squaredNorm() <= distance * distance &&
               std::binary_search(triangles.begin(), triangles.end(), t);
      return !within;
    });
    return within;
  }

  /// Depth of a point of the other surface, 0 outside and on the surface. It counts for the nearest faces that face the
  /// point. The other side of a thin wall, which points the same way as the other surface, is ignored.
  double meet(const Vector3& p, const Vector3& normal) {
    if (!body_.tree.box().contains(p) || !body_.contains(p)) return 0.0;
    const TriangleTree::Nearest nearest = body_.tree.nearest(p, std::numeric_limits<double>::infinity());
    if (nearest.distance <= kLeastDepth) return 0.0;
    const bool isOtherSide = body_.normals[nearest.triangle].dot(normal) > -kFacing;
    if (!countForNearest(p, normal, nearest) && isOtherSide) {
      const TriangleTree::Nearest across = acrossTheWall(p, normal, nearest);
      if (isFacing(across.triangle, normal)) count(across);
    }
    takeDeepest(p, nearest);
    return nearest.distance;
  }

  /// Counts the depth for every face that faces the point and is as near as the nearest one, since rounding decides
  /// between them. True if there is one.
  bool countForNearest(const Vector3& p, const Vector3& normal, const TriangleTree::Nearest& nearest) {
    bool found = false;
    const double reach = nearest.distance + kSameDistance;
    const Vector3 around = Vector3::Constant(reach);
    body_.tree.visit(Box3(p - around, p + around), [&](std::uint32_t t) {
      if (isFacing(t, normal) && (nearestPoint(body_.tree.triangles()[t], p) - p).squaredNorm() <= reach * reach) {
        count({nearest.distance, t});
        found = true;
      }
      return true;
    });
    return found;
  }

  void count(const TriangleTree::Nearest& met) {
    double& depth = overlap_.depths[body_.regions.of[met.triangle]];
    depth = std::max(depth, met.distance);
  }

  /// True if the triangle faces the other surface, which has this normal.
  bool isFacing(std::uint32_t triangle, const Vector3& normal) const {
    return body_.normals[triangle].dot(normal) < kFacing;
  }

  /// The other face of the wall that contains the point and to which the nearest face belongs: the nearest face
  /// straight behind it that does not point along the normal, within the largest overlap that is no clash. A face
  /// beside the point does not count, such as that of a hole beside a face that the other body rests on. The nearest
  /// face if there is none.
  TriangleTree::Nearest acrossTheWall(const Vector3& p, const Vector3& normal,
                                      const TriangleTree::Nearest& nearest) const {
    const Vector3 inwards = -body_.normals[nearest.triangle];
    for (double reach = kFirstReach; reach < 2.0 * kClashOverlap; reach *= 2.0) {
      const auto found = straightBehind(p, normal, inwards, std::min(reach, kClashOverlap));
      if (found) return *found;
    }
    return nearest;
  }

  std::optional<TriangleTree::Nearest> straightBehind(const Vector3& p, const Vector3& normal, const Vector3& inwards,
                                                      double within) const {
    std::optional<TriangleTree::Nearest> across;
    double least = within * within;
    const Vector3 reach = Vector3::Constant(within);
    body_.tree.visit(Box3(p - reach, p + reach), [&](std::uint32_t t) {
      if (body_.normals[t].dot(normal) > -kFacing) return true;
      const Vector3 way = nearestPoint(body_.tree.triangles()[t], p) - p;
      const double squared = way.squaredNorm();
      if (squared >= least || way.dot(inwards) < kStraightThrough * std::sqrt(squared)) return true;
      across = TriangleTree::Nearest{std::sqrt(squared), t};
      least = squared;
      return true;
    });
    return across;
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

/// Range of the sine of the angle between the axes of a hole and of a tilted shaft in it.
constexpr double kLeastTilt = 1e-3;
constexpr double kLargestTilt = 0.2;

/// A hole of a body, and a tilted round shaft of another body that passes through it.
struct ShaftInHole {
  const RoundFace& hole;
  const RoundFace& shaft;

  double alongHole(const Vector3& p) const { return (p - hole.point).dot(hole.axis); }
  double fromAxisOfHole(const Vector3& p) const { return (p - hole.point).cross(hole.axis).norm(); }
  Vector3 endOfShaft(double along) const { return shaft.point + along * shaft.axis; }

  bool goesThrough() const {
    if (hole.isShaft || !shaft.isShaft || shaft.radius > hole.radius + kClashOverlap) return false;
    const double tilt = hole.axis.cross(shaft.axis).norm();
    if (tilt < kLeastTilt || tilt > kLargestTilt) return false;
    const auto [low, high] = std::minmax({alongHole(endOfShaft(shaft.low)), alongHole(endOfShaft(shaft.high))});
    return low < hole.low && high > hole.high && fromAxisOfHole(shaftAt(hole.low)) < hole.radius &&
           fromAxisOfHole(shaftAt(hole.high)) < hole.radius;
  }

  /// The point of the shaft's axis at this height along the hole.
  Vector3 shaftAt(double along) const {
    return shaft.point + (along - alongHole(shaft.point)) / shaft.axis.dot(hole.axis) * shaft.axis;
  }

  double fromAxisOfShaft(const Vector3& p) const { return (p - shaft.point).cross(shaft.axis).norm(); }
  double outsideOfShaft() const { return shaft.radius + vertexTolerance(shaft.radius); }
  bool isInShaft(const Vector3& p) const { return fromAxisOfShaft(p) <= outsideOfShaft(); }

  /// True if the body with the shaft is thicker than the shaft somewhere, as at a knob, and not much thicker than the
  /// hole. A wider hole would let it pass.
  bool hasKnob(const PlacedBody& body) const {
    VertexWelder welder(body.mesh.vertices.size());
    std::vector<std::uint32_t> number;
    for (const Vector3& vertex : body.mesh.vertices) number.push_back(welder.indexOf(vertex));
    std::vector<double> from;
    for (const Vector3& vertex : welder.vertices()) from.push_back(fromAxisOfShaft(vertex));
    std::vector<bool> isFarthest(from.size(), true);
    for (const TriangleIndices& corners : body.mesh.triangles) {
      for (const std::uint32_t a : corners) {
        for (const std::uint32_t b : corners) {
          if (from[number[b]] > from[number[a]]) isFarthest[number[a]] = false;
        }
      }
    }
    for (std::size_t i = 0; i < from.size(); ++i) {
      const bool isThicker = from[i] > outsideOfShaft() && from[i] <= hole.radius + 2.0 * kClashOverlap;
      if (isFarthest[i] && isThicker) return true;
    }
    return false;
  }

  /// Depth of the shaft in the wall of the hole, across the axis of the hole, metres.
  double depth(const PlacedBody& body) const {
    const double middle = 0.5 * (hole.low + hole.high);
    const double half = 0.5 * (hole.high - hole.low);
    double farthest = 0.0;
    for (const Triangle& triangle : body.tree.triangles()) {
      if (!std::all_of(triangle.begin(), triangle.end(), [&](const Vector3& p) { return isInShaft(p); })) continue;
      // Within a triangle, the distance from an axis is largest at a corner of the part that is in the hole.
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector3& from = triangle[i];
        const Vector3 way = triangle[(i + 1) % 3] - from;
        const double along = alongHole(from) - middle;
        const double step = way.dot(hole.axis);
        if (std::abs(along) <= half) farthest = std::max(farthest, fromAxisOfHole(from));
        for (const double end : {-half, half}) {
          const double share = step != 0.0 ? (end - along) / step : -1.0;
          if (share >= 0.0 && share <= 1.0) farthest = std::max(farthest, fromAxisOfHole(from + share * way));
        }
      }
    }
    return farthest - hole.radius;
  }
};

/// Adds the depth of tilted shafts at the walls of their holes. A tilted shaft is deepest at the rims, where the face
/// around the hole is nearer to its points than the wall. The wall counts across the axis of the hole. A shaft that is
/// as deep as a clash is beside the hole, or a clash.
void deepenHoles(const PlacedBody& body, const PlacedBody& other, Overlap& overlap) {
  for (const RoundFace& hole : body.rounds) {
    for (const RoundFace& round : other.rounds) {
      const ShaftInHole pair{hole, round};
      if (!pair.goesThrough()) continue;
      const double depth = pair.depth(other);
      if (depth <= kLeastDepth || depth > kClashOverlap || pair.hasKnob(other)) continue;
      for (std::uint32_t t = 0; t < body.mesh.triangles.size(); ++t) {
        double& ofRegion = overlap.depths[body.regions.of[t]];
        if (ofRegion > 0.0 && ofRegion < depth && isOf(hole, body, t)) ofRegion = depth;
      }
    }
  }
}

}  // namespace

Overlap overlapIn(const PlacedBody& body, const PlacedBody& other, const StopToken& stop) {
  if (!body.interior || !body.tree.box().intersects(other.tree.box())) {
    return {std::vector<double>(body.regions.count, 0.0), 0.0, 0.0};
  }
  Overlap overlap = DepthSearch(body, other).search(stop);
  if (overlap.deepest > 0.0) deepenHoles(body, other, overlap);
  return overlap;
}

}  // namespace glissade::evidence
