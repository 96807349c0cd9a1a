#include "engine/evidence/cut_shape.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "engine/evidence/surface_cut.h"

namespace glissade::evidence {
namespace {

constexpr double kSameLine = 1e-8;      ///< metres: edges of pieces within this distance are one line
constexpr double kConnected = 1e-7;     ///< metres: pieces within this distance belong to one part of the overlap
constexpr double kLeastWeb = 1e-6;      ///< metres: thinner material does not connect a body
constexpr double kClearlyAround = 1.9;  ///< least ratio of the two wall volumes that decides which body has the hole
constexpr double kFlatWall = 0.99;      ///< a wall is flat if the sum of its normals has this share of its area
constexpr std::size_t kMostParts = 400'000;

/// A piece of the surface of the overlap.
struct OverlapPiece {
  Polygon polygon;
  bool isOfOne = false;              ///< it belongs to the surface of `one`
  bool isShared = false;             ///< it belongs to both surfaces
  Vector3 normal = Vector3::Zero();  ///< out of the overlap, length: the area
  bool isDeep = false;               ///< deeper in the other body than the deviations of the files
};

class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t of(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t k) { parent_[of(i)] = of(k); }

 private:
  std::vector<std::uint32_t> parent_;
};

/// The midpoint of the line that two convex polygons share; nothing if they share no more than a point.
std::optional<Vector3> sharedLine(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vector3& from = a[i];
    const Vector3 way = a[(i + 1) % a.size()] - from;
    const double length = way.norm();
    if (length <= kSameLine) continue;
    const Vector3 along = way / length;
    const auto isOnLine = [&](const Vector3& p) {
      return (p - from - (p - from).dot(along) * along).squaredNorm() <= kSameLine * kSameLine;
    };
    for (std::size_t k = 0; k < b.size(); ++k) {
      const Vector3& p = b[k];
      const Vector3& q = b[(k + 1) % b.size()];
      if (!isOnLine(p) || !isOnLine(q)) continue;
      const auto [low, high] = std::minmax({(p - from).dot(along), (q - from).dot(along)});
      const double first = std::max(0.0, low);
      const double last = std::min(length, high);
      if (last - first > kSameLine) return Vector3(from + 0.5 * (first + last) * along);
    }
  }
  return std::nullopt;
}

/// A connected part of the overlap, with the walls of the cuts in both bodies.
struct OverlapPart {
  std::map<std::uint32_t, bool> wallsOfOne{};  ///< groups of deep pieces of `other`: the walls of the cut in `one`
  std::map<std::uint32_t, bool> wallsOfOther{};
  std::vector<std::uint32_t> pieces{};

  bool isOverlap() const { return !wallsOfOne.empty() || !wallsOfOther.empty(); }
};

/// Shape of the walls of one body about the overlap.
struct WallShape {
  double volume = 0.0;  ///< three times the volume between the walls and the centre of the overlap
  double area = 0.0;
  Vector3 sum = Vector3::Zero();  ///< sum of the normals, weighted by area

  bool isFlat() const { return sum.norm() >= kFlatWall * area; }
};

class OverlapShape {
 public:
  OverlapShape(const PlacedBody& one, const PlacedBody& other, const StopToken& stop)
      : one_(one),
        other_(other),
        stop_(stop),
        web_(kLeastWeb + one.spacing + other.spacing + one.largestDeflection + other.largestDeflection) {}

  CutShape find() {
    if (!takePieces(one_, other_, true) || !takePieces(other_, one_, false)) return {};
    const std::vector<OverlapPart> parts = partsOf();
    CutShape shape;
    CutShape::Hole more = CutShape::Hole::Unclear;
    bool any = false;
    for (const OverlapPart& part : parts) {
      if (!part.isOverlap()) continue;
      const auto [hole, larger] = holeOf(part);
      const bool first = !any;
      any = true;
      shape.oneStaysWhole = (first || shape.oneStaysWhole) && part.wallsOfOne.size() == 1;
      shape.otherStaysWhole = (first || shape.otherStaysWhole) && part.wallsOfOther.size() == 1;
      shape.hole = first ? hole : both(shape.hole, hole);
      more = first ? larger : both(more, larger);
    }
    // If only one of the two can be cut, it has the hole where its walls are around more of the overlap.
    if (shape.hole == CutShape::Hole::Unclear && shape.oneStaysWhole != shape.otherStaysWhole) shape.hole = more;
    return stop_.stopRequested() ? CutShape() : shape;
  }

 private:
  static CutShape::Hole both(CutShape::Hole a, CutShape::Hole b) {
    if (a == b || b == CutShape::Hole::Either) return a;
    return a == CutShape::Hole::Either ? b : CutShape::Hole::Unclear;
  }

  /// Collects pieces of the body's surface inside of the other body, and pieces that both surfaces share with both
  /// bodies on the same side.
  bool takePieces(const PlacedBody& body, const PlacedBody& other, bool isOfOne) {
    const auto take = [&](const CutPiece& cut) {
      if (cut.side == Side::Outside || pieces_.size() > kMostParts) return;
      const Vector3 middle = middleOf(cut.polygon);
      const TriangleTree::Nearest nearest = other.tree.nearest(middle, std::numeric_limits<double>::infinity());
      const Vector3& normal = body.normals[cut.triangle];
      const bool isOn = cut.side == Side::On;
      if (isOn && normal.dot(other.normals[nearest.triangle]) <= 0.0) return;
      OverlapPiece piece{cut.polygon, isOfOne, isOn, Vector3::Zero(), !isOn && nearest.distance > web_};
      for (std::size_t i = 2; i < piece.polygon.size(); ++i) {
        const Vector3& from = piece.polygon[0];
        piece.normal += 0.5 * (piece.polygon[i - 1] - from).cross(piece.polygon[i] - from).norm() * normal;
      }
      pieces_.push_back(std::move(piece));
    };
    return cutSurface(body, other, take, stop_) && pieces_.size() <= kMostParts;
  }

  /// True if the pieces belong to one surface and are connected deep enough in the other body.
  bool areOneWall(const OverlapPiece& a, const OverlapPiece& b) const {
    if (a.isOfOne != b.isOfOne || a.isShared || b.isShared) return false;
    const auto line = sharedLine(a.polygon, b.polygon);
    const PlacedBody& in = a.isOfOne ? other_ : one_;
    return line && in.tree.nearest(*line, web_).distance >= web_;
  }

  std::vector<OverlapPart> partsOf() {
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> pieceOf;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      const Polygon& polygon = pieces_[i].polygon;
      for (std::size_t k = 2; k < polygon.size(); ++k) {
        triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
        pieceOf.push_back(i);
      }
    }
    Groups parts(pieces_.size());
    Groups walls(pieces_.size());
    const TriangleTree tree(triangles);
    tree.visitPairs(tree, kConnected, [&](std::uint32_t a, std::uint32_t b) {
      const std::uint32_t i = pieceOf[a];
      const std::uint32_t k = pieceOf[b];
      if (i >= k || (parts.of(i) == parts.of(k) && walls.of(i) == walls.of(k))) return !stop_.stopRequested();
      const bool touch = trianglesMeet(triangles[a], triangles[b]) ||
                         triangleDistance(triangles[a], triangles[b]).squared <= kConnected * kConnected;
      if (touch) parts.join(i, k);
      if (touch && walls.of(i) != walls.of(k) && areOneWall(pieces_[i], pieces_[k])) walls.join(i, k);
      return !stop_.stopRequested();
    });
    std::map<std::uint32_t, OverlapPart> found;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      OverlapPart& part = found[parts.of(i)];
      part.pieces.push_back(i);
      if (pieces_[i].isDeep) (pieces_[i].isOfOne ? part.wallsOfOther : part.wallsOfOne)[walls.of(i)] = true;
    }
    std::vector<OverlapPart> all;
    for (auto& [root, part] : found) all.push_back(std::move(part));
    return all;
  }

  /// The body with the hole, and the body whose walls enclose more of the overlap.
  std::pair<CutShape::Hole, CutShape::Hole> holeOf(const OverlapPart& part) const {
    using Hole = CutShape::Hole;
    Vector3 center = Vector3::Zero();
    double area = 0.0;
    for (const std::uint32_t i : part.pieces) {
      center += pieces_[i].normal.norm() * middleOf(pieces_[i].polygon);
      area += pieces_[i].normal.norm();
    }
    center /= area;
    WallShape wallsOfOne;
    WallShape wallsOfOther;
    for (const std::uint32_t i : part.pieces) {
      if (pieces_[i].isShared) continue;
      WallShape& around = pieces_[i].isOfOne ? wallsOfOther : wallsOfOne;
      around.volume += pieces_[i].normal.dot(middleOf(pieces_[i].polygon) - center);
      around.area += pieces_[i].normal.norm();
      around.sum += pieces_[i].normal;
    }
    if (wallsOfOne.isFlat() && wallsOfOther.isFlat()) return {Hole::Either, Hole::Either};
    const double ofOne = std::max(0.0, wallsOfOne.volume);
    const double ofOther = std::max(0.0, wallsOfOther.volume);
    const Hole more = ofOne >= ofOther ? Hole::One : Hole::Other;
    const bool isClear = std::max(ofOne, ofOther) > kClearlyAround * std::min(ofOne, ofOther);
    return {isClear ? more : Hole::Unclear, more};
  }

  const PlacedBody& one_;
  const PlacedBody& other_;
  const StopToken& stop_;
  double web_;  ///< metres: thinner material may be missing
  std::vector<OverlapPiece> pieces_;
};

}  // namespace

CutShape cutShapeOf(const PlacedBody& one, const PlacedBody& other, const StopToken& stop) {
  if (!one.interior || !other.interior || !one.tree.box().intersects(other.tree.box())) return {};
  return OverlapShape(one, other, stop).find();
}

Cut cutOf(const CutShape& shape, bool namesOne, bool namesOther) {
  if (namesOne != namesOther) {
    if (!(namesOne ? shape.oneStaysWhole : shape.otherStaysWhole)) return Cut::NotWhole;
    return namesOne ? Cut::One : Cut::Other;
  }
  if (!shape.oneStaysWhole && !shape.otherStaysWhole) return Cut::NotWhole;
  switch (shape.hole) {
    case CutShape::Hole::One: return shape.oneStaysWhole ? Cut::One : Cut::NotClear;
    case CutShape::Hole::Other: return shape.otherStaysWhole ? Cut::Other : Cut::NotClear;
    case CutShape::Hole::Either: return shape.oneStaysWhole ? Cut::One : Cut::Other;
    case CutShape::Hole::Unclear: break;
  }
  return Cut::NotClear;
}

}  // namespace glissade::evidence
