#include "engine/check/shaft_rings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "engine/check/overlap.h"
#include "engine/geometry/vertex_welder.h"

namespace glissade::check {
namespace {

/// Divides the triangles of one shaft at one height.
class RingCut {
 public:
  /// `apart`: metres that the height is apart from all corners of the shaft, at least.
  RingCut(const PlacedBody& body, const RoundFace& shaft, double height, double apart, DividedTriangles& divided)
      : apart_(std::max(vertexTolerance(shaft.radius), apart)),
        divided_(divided),
        vertices_(divided.vertices(body.mesh.vertices)) {
    VertexWelder welder(vertices_.size());
    for (const Vector3& vertex : vertices_) {
      over_.push_back((vertex - shaft.point).dot(shaft.axis) - height);
      number_.push_back(welder.indexOf(vertex));
    }
    for (const std::uint32_t parent : divided.parents) isOfShaft_.push_back(isOf(shaft, body, parent));
  }

  void cut() {
    if (!isPossible()) return;
    DividedTriangles cut{divided_.newVertices, {}, {}};
    for (std::size_t t = 0; t < divided_.triangles.size(); ++t) {
      if (!isOfShaft_[t] || !isCrossed(divided_.triangles[t])) {
        add(divided_.triangles[t], t, cut);
      } else {
        cutTriangle(t, cut);
      }
    }
    divided_ = std::move(cut);
  }

 private:
  using EdgeEnds = std::pair<std::uint32_t, std::uint32_t>;

  EdgeEnds edgeOf(std::uint32_t a, std::uint32_t b) const { return std::minmax({number_[a], number_[b]}); }

  bool isCrossedBetween(std::uint32_t a, std::uint32_t b) const { return (over_[a] > 0.0) != (over_[b] > 0.0); }

  bool isCrossed(const TriangleIndices& t) const {
    return isCrossedBetween(t[0], t[1]) || isCrossedBetween(t[1], t[2]);
  }

  bool isPossible() const {
    std::map<EdgeEnds, bool> crossed;  // edges of the shaft, with whether another face has the edge, too
    bool hasCorner = false;
    forEachCrossedEdge(true, [&](std::uint32_t a, std::uint32_t b) { crossed[edgeOf(a, b)] = false; });
    for (std::size_t t = 0; t < divided_.triangles.size() && !hasCorner; ++t) {
      const TriangleIndices& corners = divided_.triangles[t];
      hasCorner = isOfShaft_[t] && std::any_of(corners.begin(), corners.end(),
                                               [&](std::uint32_t corner) { return std::abs(over_[corner]) <= apart_; });
    }
    bool isShared = false;
    forEachCrossedEdge(
        false, [&](std::uint32_t a, std::uint32_t b) { isShared = isShared || crossed.count(edgeOf(a, b)) == 1; });
    return !crossed.empty() && !hasCorner && !isShared;
  }

  template <class Visit>
  void forEachCrossedEdge(bool ofShaft, const Visit& visit) const {
    for (std::size_t t = 0; t < divided_.triangles.size(); ++t) {
      if (isOfShaft_[t] != ofShaft) continue;
      const TriangleIndices& corners = divided_.triangles[t];
      for (std::size_t i = 0; i < 3; ++i) {
        if (isCrossedBetween(corners[i], corners[(i + 1) % 3])) visit(corners[i], corners[(i + 1) % 3]);
      }
    }
  }

  void add(const TriangleIndices& triangle, std::size_t of, DividedTriangles& cut) const {
    cut.triangles.push_back(triangle);
    cut.parents.push_back(divided_.parents[of]);
  }

  /// One corner is on the one side, and two are on the other.
  void cutTriangle(std::size_t t, DividedTriangles& cut) {
    const TriangleIndices& corners = divided_.triangles[t];
    std::size_t alone = 0;
    while (!isCrossedBetween(corners[alone], corners[(alone + 1) % 3]) ||
           !isCrossedBetween(corners[alone], corners[(alone + 2) % 3])) {
      ++alone;
    }
    const std::uint32_t a = corners[alone];
    const std::uint32_t b = corners[(alone + 1) % 3];
    const std::uint32_t c = corners[(alone + 2) % 3];
    const std::uint32_t onB = vertexOn(a, b, cut);
    const std::uint32_t onC = vertexOn(a, c, cut);
    add({a, onB, onC}, t, cut);
    add({onB, b, c}, t, cut);
    add({onB, c, onC}, t, cut);
  }

  /// The vertex on an edge. Both triangles at the edge get an equal position, because it is computed from the end with
  /// the lower number.
  std::uint32_t vertexOn(std::uint32_t a, std::uint32_t b, DividedTriangles& cut) {
    if (number_[a] > number_[b]) std::swap(a, b);
    const auto next = static_cast<std::uint32_t>(vertices_.size() + made_.size());
    const auto [known, isNew] = made_.try_emplace(edgeOf(a, b), next);
    if (isNew) cut.newVertices.push_back({a, b, over_[a] / (over_[a] - over_[b])});
    return known->second;
  }

  double apart_;
  DividedTriangles& divided_;
  std::vector<Vector3> vertices_;
  std::vector<double> over_;           ///< metres above the height, of each vertex
  std::vector<std::uint32_t> number_;  ///< of each vertex; equal for equal positions
  std::vector<bool> isOfShaft_;        ///< of each triangle
  std::map<EdgeEnds, std::uint32_t> made_;
};

bool areOfOneCylinder(const RoundFace& one, const RoundFace& other) {
  const double off = vertexTolerance(one.radius);
  return std::abs(one.radius - other.radius) <= off && one.axis.cross(other.axis).norm() <= kParallelAxes &&
         (other.point - one.point).cross(one.axis).norm() <= off;
}

/// Rings that overlap become one.
void addTo(std::vector<Ring>& rings, const Ring& ring) {
  for (Ring& known : rings) {
    if (!areOfOneCylinder(known.round, ring.round)) continue;
    const auto onKnown = [&](double height) {
      return (ring.round.point + height * ring.round.axis - known.round.point).dot(known.round.axis);
    };
    const auto [low, high] = std::minmax({onKnown(ring.low), onKnown(ring.high)});
    if (low > known.high || high < known.low) continue;
    known.low = std::min(known.low, low);
    known.high = std::max(known.high, high);
    return;
  }
  rings.push_back(ring);
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

std::vector<Ring> ringsInHoles(const PlacedBody& body, const PlacedBody& other, double beside) {
  std::vector<Ring> rings;
  for (const RoundFace& shaft : body.rounds) {
    for (const RoundFace& hole : other.rounds) {
      if (!shaft.isShaft || hole.isShaft || hole.axis.cross(shaft.axis).norm() > kParallelAxes) continue;
      const Vector3 from = hole.point - shaft.point;
      if (from.cross(shaft.axis).norm() + std::abs(shaft.radius - hole.radius) > kClashOverlap) continue;
      const double middle = from.dot(shaft.axis) + 0.5 * hole.axis.dot(shaft.axis) * (hole.low + hole.high);
      const double half = 0.5 * (hole.high - hole.low) + beside;
      const Ring ring{shaft, std::max(shaft.low, middle - half), std::min(shaft.high, middle + half)};
      if (ring.low < ring.high) addTo(rings, ring);
    }
  }
  return rings;
}

DividedTriangles dividedAtRings(const PlacedBody& body, const std::vector<Ring>& rings, double beside) {
  constexpr double kApart = 0.2;
  DividedTriangles divided{{}, body.mesh.triangles, {}};
  for (std::uint32_t t = 0; t < divided.triangles.size(); ++t) divided.parents.push_back(t);
  for (const Ring& ring : rings) {
    for (const double end : {ring.low, ring.high}) {
      for (const double height : {end - beside, end, end + beside}) {
        RingCut(body, ring.round, height, kApart * beside, divided).cut();
      }
    }
  }
  return divided;
}

}  // namespace glissade::check
