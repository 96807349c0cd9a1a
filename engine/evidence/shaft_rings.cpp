#include "engine/evidence/shaft_rings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engine/evidence/overlap.h"
#include "engine/geometry/vertex_welder.h"

namespace glissade::evidence {
namespace {

/// Slices the triangles of shafts of a body.
class ShaftSlicer {
 public:
  explicit ShaftSlicer(const PlacedBody& body) : body_(body) {
    VertexWelder welder(body.mesh.vertices.size());
    for (const Vector3& vertex : body.mesh.vertices) number_.push_back(welder.indexOf(vertex));
  }

  /// Slices the shaft at those of the heights that are possible, the first ones first. `apart`: metres between a height
  /// and the corners of the shaft and the other heights, at least.
  void slice(const RoundFace& shaft, const std::vector<double>& wanted, double apart) {
    measure(shaft);
    std::vector<std::uint32_t> ofShaft;
    for (std::uint32_t t = 0; t < body_.mesh.triangles.size(); ++t) {
      if (slices_.count(t) == 0 && isOf(shaft, body_, t)) ofShaft.push_back(t);
    }
    findCuts(wanted, std::max(apart, vertexTolerance(shaft.radius)), ofShaft);
    if (cuts_.empty()) return;
    for (const std::uint32_t t : ofShaft) slice(t);
  }

  DividedTriangles divided() && {
    DividedTriangles divided{std::move(newVertices_), {}, {}};
    for (std::uint32_t t = 0; t < body_.mesh.triangles.size(); ++t) {
      const auto sliced = slices_.find(t);
      const std::vector<TriangleIndices> whole{body_.mesh.triangles[t]};
      for (const TriangleIndices& piece : sliced == slices_.end() ? whole : sliced->second) {
        divided.triangles.push_back(piece);
        divided.parents.push_back(t);
      }
    }
    return divided;
  }

 private:
  using EdgeEnds = std::pair<std::uint32_t, std::uint32_t>;

  EdgeEnds edgeOf(std::uint32_t a, std::uint32_t b) const { return std::minmax({number_[a], number_[b]}); }

  void measure(const RoundFace& shaft) {
    height_.clear();
    for (const Vector3& vertex : body_.mesh.vertices) height_.push_back((vertex - shaft.point).dot(shaft.axis));
    height_.resize(height_.size() + newVertices_.size());
    made_.clear();
  }

  void findCuts(const std::vector<double>& wanted, double apart, const std::vector<std::uint32_t>& ofShaft) {
    std::vector<Range> barred = sharedHeights(ofShaft);
    const auto barAround = [&](double height) { barred.push_back({height - apart, height + apart}); };
    for (const std::uint32_t t : ofShaft) {
      for (const std::uint32_t corner : body_.mesh.triangles[t]) barAround(height_[corner]);
    }
    cuts_.clear();
    for (const double height : wanted) {
      const bool isBarred = std::any_of(barred.begin(), barred.end(),
                                        [&](const Range& each) { return height >= each.low && height <= each.high; });
      if (isBarred) continue;
      cuts_.push_back(height);
      barAround(height);
    }
    std::sort(cuts_.begin(), cuts_.end());
  }

  /// The heights of the edges that the shaft shares with other faces.
  std::vector<Range> sharedHeights(const std::vector<std::uint32_t>& ofShaft) const {
    std::set<EdgeEnds> edges;
    forEachEdge(ofShaft, [&](std::uint32_t a, std::uint32_t b) { edges.insert(edgeOf(a, b)); });
    std::vector<std::uint32_t> others;
    for (std::uint32_t t = 0; t < body_.mesh.triangles.size(); ++t) {
      if (!std::binary_search(ofShaft.begin(), ofShaft.end(), t)) others.push_back(t);
    }
    std::vector<Range> heights;
    forEachEdge(others, [&](std::uint32_t a, std::uint32_t b) {
      if (edges.count(edgeOf(a, b)) == 0) return;
      const auto [low, high] = std::minmax(height_[a], height_[b]);
      heights.push_back({low, high});
    });
    return heights;
  }

  template <class Visit>
  void forEachEdge(const std::vector<std::uint32_t>& triangles, const Visit& visit) const {
    for (const std::uint32_t t : triangles) {
      const auto& [a, b, c] = body_.mesh.triangles[t];
      visit(a, b);
      visit(b, c);
      visit(c, a);
    }
  }

  /// Slices a triangle from its lowest corner upwards. Its longest edge and the way along the two other edges have the
  /// same cuts, and each cut is an edge of two pieces.
  void slice(std::uint32_t t) {
    TriangleIndices corners = body_.mesh.triangles[t];
    const auto isLower = [&](std::uint32_t a, std::uint32_t b) { return height_[a] < height_[b]; };
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), isLower), corners.end());
    const auto& [lowest, second, third] = corners;
    const bool isThirdHighest = !isLower(third, second);
    const std::uint32_t middle = isThirdHighest ? second : third;
    const std::uint32_t highest = isThirdHighest ? third : second;
    std::vector<std::uint32_t> around;
    climb(lowest, middle, around);
    climb(middle, highest, around);
    std::vector<std::uint32_t> straight{lowest};
    climb(lowest, highest, straight);
    straight.pop_back();
    if (straight.size() == 1) return;
    std::vector<TriangleIndices>& pieces = slices_[t];
    auto a = around.begin();
    auto s = straight.begin();
    while (a + 1 != around.end() || s + 1 != straight.end()) {
      const bool goesAround = s + 1 == straight.end() || isLower(*(a + 1), *(s + 1));
      const std::uint32_t next = goesAround ? *(a + 1) : *(s + 1);
      pieces.push_back(isThirdHighest ? TriangleIndices{*s, *a, next} : TriangleIndices{*a, *s, next});
      ++(goesAround ? a : s);
    }
  }

  /// Adds the cuts of an edge from its lower end upwards, and its upper end.
  void climb(std::uint32_t low, std::uint32_t high, std::vector<std::uint32_t>& way) {
    auto cut = std::upper_bound(cuts_.begin(), cuts_.end(), height_[low]);
    for (; cut != cuts_.end() && *cut < height_[high]; ++cut) way.push_back(vertexAt(*cut, low, high));
    way.push_back(high);
  }

  /// The vertex on an edge. Both triangles at the edge get an equal position, because it is computed from the end with
  /// the lower number.
  std::uint32_t vertexAt(double height, std::uint32_t a, std::uint32_t b) {
    if (number_[a] > number_[b]) std::swap(a, b);
    const auto next = static_cast<std::uint32_t>(height_.size());
    const auto [known, isNew] = made_.try_emplace({edgeOf(a, b), height}, next);
    if (isNew) {
      newVertices_.push_back({a, b, (height - height_[a]) / (height_[b] - height_[a])});
      height_.push_back(height);
    }
    return known->second;
  }

  const PlacedBody& body_;
  std::vector<std::uint32_t> number_;  ///< of each vertex of the body; equal for equal positions
  std::vector<double> height_;         ///< of each vertex along the shaft, metres
  std::vector<double> cuts_;           ///< heights, ascending
  std::map<std::pair<EdgeEnds, double>, std::uint32_t> made_;
  std::vector<NewVertex> newVertices_;
  std::map<std::uint32_t, std::vector<TriangleIndices>> slices_;  ///< of each sliced triangle
};

/// The part of the shaft in the hole, with so many metres beside the hole.
std::optional<Range> ringIn(const RoundFace& shaft, const RoundFace& hole, double beside) {
  if (hole.isShaft || hole.axis.cross(shaft.axis).norm() > kParallelAxes) return std::nullopt;
  const Vector3 from = hole.point - shaft.point;
  if (from.cross(shaft.axis).norm() + std::abs(shaft.radius - hole.radius) > kClashOverlap) return std::nullopt;
  const double middle = from.dot(shaft.axis) + 0.5 * hole.axis.dot(shaft.axis) * (hole.low + hole.high);
  const double half = 0.5 * (hole.high - hole.low) + beside;
  const Range ring{std::max(shaft.low, middle - half), std::min(shaft.high, middle + half)};
  return ring.low < ring.high ? std::optional(ring) : std::nullopt;
}

/// Rings that overlap become one.
std::vector<Range> unitedRings(std::vector<Range> rings) {
  std::sort(rings.begin(), rings.end(), [](const Range& one, const Range& other) { return one.low < other.low; });
  std::vector<Range> apart;
  for (const Range& ring : rings) {
    if (apart.empty() || ring.low > apart.back().high) {
      apart.push_back(ring);
    } else {
      apart.back().take(ring);
    }
  }
  return apart;
}

}  // namespace

std::vector<Vector3> DividedTriangles::vertices(const std::vector<Vector3>& whole) const {
  std::vector<Vector3> all = whole;
  for (const NewVertex& each : newVertices) {
    const Vector3 vertex = (1.0 - each.share) * all[each.from] + each.share * all[each.to];
    all.push_back(vertex);
  }
  return all;
}

std::vector<ShaftRings> ringsInHoles(const PlacedBody& body, const PlacedBody& other, double beside) {
  std::vector<ShaftRings> found;
  for (const RoundFace& shaft : body.rounds) {
    if (!shaft.isShaft) continue;
    std::vector<Range> rings;
    for (const RoundFace& hole : other.rounds) {
      if (const auto ring = ringIn(shaft, hole, beside)) rings.push_back(*ring);
    }
    if (!rings.empty()) found.push_back({shaft, unitedRings(std::move(rings))});
  }
  return found;
}

DividedTriangles dividedAtRings(const PlacedBody& body, const std::vector<ShaftRings>& rings, double beside) {
  constexpr double kApart = 0.2;
  ShaftSlicer slicer(body);
  for (const ShaftRings& each : rings) {
    std::vector<double> heights;
    for (const double way : {0.0, -beside, beside}) {
      for (const Range& ring : each.rings) heights.insert(heights.end(), {ring.low + way, ring.high + way});
    }
    slicer.slice(each.shaft, heights, kApart * beside);
  }
  return std::move(slicer).divided();
}

}  // namespace glissade::evidence
