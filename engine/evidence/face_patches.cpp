#include "engine/evidence/face_patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "engine/geometry/joined_sets.h"
#include "engine/geometry/vertex_welder.h"

namespace glissade::evidence {
namespace {

constexpr double kFinestPatch = 1.0 / 32.0;  ///< share of the diagonal of the common box of both bodies
/// Least length of pieces, in depths: corners of such pieces move less than the pieces are long when they are thinned.
constexpr double kDepths = 4.0;
/// Length of a ring beside its hole, as a share of the reach of a patch. The shaft beside the ring is out of reach.
constexpr double kBesideRing = 1.25;
/// Length of the pieces on both sides of an end of a ring, as a share of the reach of a patch: short enough not to be
/// divided again.
constexpr double kAtEndOfRing = 0.6;
constexpr std::size_t kAngles = 72;
constexpr std::size_t kMostDivided = 200'000;

enum class Cover : std::uint8_t { None, Part, All };

/// The numbers of the ends of an edge, the lower one first.
using EdgeEnds = std::pair<std::uint32_t, std::uint32_t>;

/// A triangle that is cut by a few planes, each of which adds at most one corner. If rounding adds more corners than
/// there is room for, they are dropped and the polygon is smaller.
class ConvexPolygon {
 public:
  explicit ConvexPolygon(const Triangle& triangle) { std::copy(triangle.begin(), triangle.end(), corners_.begin()); }

  bool empty() const { return count_ == 0; }
  std::size_t size() const { return count_; }
  const Vector3* begin() const { return corners_.data(); }
  const Vector3* end() const { return corners_.data() + count_; }

  /// The part with normal.dot(p) <= offset.
  ConvexPolygon keptBelow(const Vector3& normal, double offset) const {
    ConvexPolygon kept;
    for (std::size_t i = 0; i < count_; ++i) {
      const Vector3& from = corners_[i];
      const Vector3& to = corners_[(i + 1) % count_];
      const double a = normal.dot(from) - offset;
      const double b = normal.dot(to) - offset;
      if (a <= 0.0) kept.add(from);
      if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0)) kept.add(from + a / (a - b) * (to - from));
    }
    return kept;
  }

 private:
  ConvexPolygon() : count_(0) {}

  void add(const Vector3& corner) {
    if (count_ < corners_.size()) corners_[count_++] = corner;
  }

  std::array<Vector3, 16> corners_;
  std::size_t count_ = 3;
};

class PatchFinder {
 public:
  PatchFinder(const PatchQuestion& question, const StopToken& stop)
      : question_(question), body_(question.body), stop_(stop) {
    const Vector3 reach = Vector3::Constant(question.above);
    const Box3& box = question.other.tree.box();
    const double common = body_.tree.box().intersection(Box3(box.min() - reach, box.max() + reach)).diagonal().norm();
    const double deepest = *std::max_element(question.depths.begin(), question.depths.end());
    size_ = std::max(kFinestPatch * common, kDepths * deepest);
    findFamilies();
  }

  std::optional<FacePatches> find() {
    std::vector<ShaftRings> shafts = ringsInHoles(body_, question_.other, kBesideRing * size_);
    std::erase_if(shafts, [&](const ShaftRings& each) { return !hasDepth(each.shaft); });
    begin(dividedAtRings(body_, shafts, kAtEndOfRing * size_));
    for (const RoundFace& round : body_.rounds) {
      if (!round.isShaft) coverAround(round, {round.low, round.high});
    }
    for (const ShaftRings& each : shafts) {
      for (const Range& ring : each.rings) coverAround(each.shaft, ring);
    }
    while (!stop_.stopRequested() && pieces_.size() < kMostDivided) {
      const std::set<EdgeEnds> edges = edgesToDivide();
      if (edges.empty()) return patches();
      divide(edges);
    }
    return std::nullopt;
  }

 private:
  struct Piece {
    TriangleIndices corners;
    std::uint32_t parent;
    Cover cover;
  };

  double depthOf(std::uint32_t parent) const { return question_.depths[body_.regions.of[parent]]; }

  Triangle cornersOf(const Piece& piece) const {
    return {vertices_[piece.corners[0]], vertices_[piece.corners[1]], vertices_[piece.corners[2]]};
  }

  EdgeEnds edgeOf(const Piece& piece, std::size_t i) const {
    return std::minmax(number_[piece.corners[i]], number_[piece.corners[(i + 1) % 3]]);
  }

  double lengthOf(const Piece& piece, std::size_t i) const {
    return (vertices_[piece.corners[i]] - vertices_[piece.corners[(i + 1) % 3]]).norm();
  }

  /// The longest edge; of equal ones the first by its ends, so that both pieces at an edge choose the same.
  std::size_t longestOf(const Piece& piece) const {
    std::size_t longest = 0;
    for (const std::size_t i : {1, 2}) {
      const double own = lengthOf(piece, i);
      const double known = lengthOf(piece, longest);
      if (own > known || (own == known && edgeOf(piece, i) < edgeOf(piece, longest))) longest = i;
    }
    return longest;
  }

  /// Gives one number to all regions of a smooth surface.
  void findFamilies() {
    JoinedSets families(body_.regions.count);
    for (std::uint32_t r = 0; r < body_.regions.next.size(); ++r) {
      for (const std::uint32_t next : body_.regions.next[r]) families.join(r, next);
    }
    family_ = std::move(families).all();
  }

  /// True if the other surface is below the triangle, a little above it, or beside it by at most the size of a piece. A
  /// surface beside the triangle counts only if it is in the body, because the surface of a hole around a round body is
  /// below the planes of that body's facets, too.
  bool isReached(const Triangle& t, const Vector3& normal, double depth) const {
    std::array<std::pair<Vector3, double>, 3> sides;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 out = (t[(i + 1) % 3] - t[i]).cross(normal).stableNormalized();
      sides[i] = {out, out.dot(t[i])};
    }
    const auto between = [&sides](ConvexPolygon polygon, double beside) {
      for (const auto& [out, offset] : sides) polygon = polygon.keptBelow(out, offset + beside);
      return polygon;
    };
    Box3 box(t[0]);
    for (const Vector3& corner : t) {
      box.extend(corner + question_.above * normal);
      box.extend(corner - (depth + question_.above) * normal);
    }
    box.min().array() -= size_;
    box.max().array() += size_;
    bool reached = false;
    question_.other.tree.visit(box, [&](std::uint32_t k) {
      if (question_.other.normals[k].dot(normal) > kFacing) return true;
      const ConvexPolygon polygon = ConvexPolygon(question_.other.tree.triangles()[k])
                                        .keptBelow(normal, normal.dot(t[0]) + question_.above)
                                        .keptBelow(-normal, -normal.dot(t[0]) + depth + question_.above);
      const ConvexPolygon near = between(polygon, size_);
      reached = !near.empty() && (!between(near, question_.above).empty() || isInBody(near));
      return !reached;
    });
    return reached;
  }

  /// True if a corner or the centre is in the body or a little above its surface.
  bool isInBody(const ConvexPolygon& polygon) const {
    const auto isIn = [this](const Vector3& p) {
      return body_.tree.nearest(p, question_.above).distance < question_.above || body_.contains(p);
    };
    Vector3 middle = Vector3::Zero();
    for (const Vector3& corner : polygon) middle += corner / static_cast<double>(polygon.size());
    return isIn(middle) || std::any_of(polygon.begin(), polygon.end(), isIn);
  }

  Cover coverOf(const Triangle& triangle, std::uint32_t parent) const {
    const double depth = depthOf(parent);
    const Vector3& normal = body_.normals[parent];
    if (depth <= 0.0 || normal.isZero() || !isReached(triangle, normal, depth)) return Cover::None;
    std::size_t longest = 0;
    const auto length = [&](std::size_t i) { return (triangle[(i + 1) % 3] - triangle[i]).norm(); };
    for (const std::size_t i : {1, 2}) longest = length(i) > length(longest) ? i : longest;
    if (length(longest) <= size_ || stop_.stopRequested()) return Cover::All;
    const Vector3 middle = 0.5 * (triangle[longest] + triangle[(longest + 1) % 3]);
    const Vector3& opposite = triangle[(longest + 2) % 3];
    const Cover one = coverOf({triangle[longest], middle, opposite}, parent);
    if (one == Cover::Part) return one;
    const Cover two = coverOf({middle, triangle[(longest + 1) % 3], opposite}, parent);
    return one == two ? one : Cover::Part;
  }

  void add(Piece piece) {
    for (std::size_t i = 0; i < 3; ++i) users_[edgeOf(piece, i)].push_back(static_cast<std::uint32_t>(pieces_.size()));
    pieces_.push_back(piece);
  }

  void begin(DividedTriangles divided) {
    vertices_ = divided.vertices(body_.mesh.vertices);
    newVertices_ = std::move(divided.newVertices);
    VertexWelder welder(vertices_.size());
    for (const Vector3& vertex : vertices_) number_.push_back(welder.indexOf(vertex));
    for (std::size_t i = 0; i < divided.triangles.size(); ++i) {
      Piece piece{divided.triangles[i], divided.parents[i], Cover::None};
      piece.cover = coverOf(cornersOf(piece), piece.parent);
      add(piece);
    }
  }

  /// A part of a round face that is covered at every angle is covered along its whole length.
  void coverAround(const RoundFace& round, const Range& ring) {
    std::vector<std::uint32_t> ofRing;
    std::array<bool, kAngles> covered{};
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      const Piece& piece = pieces_[i];
      if (depthOf(piece.parent) <= 0.0 || !isOf(round, body_, piece.parent)) continue;
      if (!isBetween(round, ring, cornersOf(piece))) continue;
      ofRing.push_back(i);
      if (piece.cover != Cover::None) markAngles(round, piece.parent, covered);
    }
    if (!std::all_of(covered.begin(), covered.end(), [](bool each) { return each; })) return;
    for (const std::uint32_t i : ofRing) pieces_[i].cover = Cover::All;
  }

  bool hasDepth(const RoundFace& round) const {
    for (std::uint32_t t = 0; t < body_.mesh.triangles.size(); ++t) {
      if (depthOf(t) > 0.0 && isOf(round, body_, t)) return true;
    }
    return false;
  }

  static bool isBetween(const RoundFace& round, const Range& ring, const Triangle& corners) {
    return std::all_of(corners.begin(), corners.end(), [&](const Vector3& p) {
      const double along = (p - round.point).dot(round.axis);
      return along >= ring.low - kOnCylinder && along <= ring.high + kOnCylinder;
    });
  }

  /// Marks the angles between the corners of a triangle that spans less than half a turn.
  void markAngles(const RoundFace& round, std::uint32_t t, std::array<bool, kAngles>& covered) const {
    const Vector3 u = round.axis.unitOrthogonal();
    const Vector3 v = round.axis.cross(u);
    const auto angleOf = [&](const Vector3& p) {
      return std::atan2((p - round.point).dot(v), (p - round.point).dot(u));
    };
    const Triangle& triangle = body_.tree.triangles()[t];
    const double first = angleOf(triangle[0]);
    double low = 0.0;
    double high = 0.0;
    for (const std::size_t i : {1, 2}) {
      const double turn = std::remainder(angleOf(triangle[i]) - first, 2.0 * std::numbers::pi);
      low = std::min(low, turn);
      high = std::max(high, turn);
    }
    const double step = 2.0 * std::numbers::pi / kAngles;
    const auto from = static_cast<long>(std::floor((first + low) / step));
    const auto to = static_cast<long>(std::floor((first + high) / step));
    constexpr long kTurn = kAngles;
    for (long i = from; i <= to; ++i) covered[static_cast<std::size_t>(((i % kTurn) + kTurn) % kTurn)] = true;
  }

  /// Edges of coarse pieces that are covered in part or have a corner at the border of a patch. Together with an edge
  /// of a piece, the piece's longest edge is divided, so that pieces stay compact and fit together.
  std::set<EdgeEnds> edgesToDivide() const {
    std::map<EdgeEnds, std::pair<bool, bool>> corners;  // with and without cover, by vertex and family
    const auto cornerOf = [&](const Piece& piece, std::size_t i) {
      return EdgeEnds{number_[piece.corners[i]], family_[body_.regions.of[piece.parent]]};
    };
    for (const Piece& piece : pieces_) {
      if (piece.cover != Cover::All) continue;
      for (std::size_t i = 0; i < 3; ++i) corners[cornerOf(piece, i)].first = true;
    }
    for (const Piece& piece : pieces_) {
      if (piece.cover == Cover::All) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        if (const auto known = corners.find(cornerOf(piece, i)); known != corners.end()) known->second.second = true;
      }
    }
    std::set<EdgeEnds> edges;
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      const Piece& piece = pieces_[i];
      bool divides = piece.cover == Cover::Part;
      for (std::size_t k = 0; k < 3 && !divides; ++k) {
        const auto known = corners.find(cornerOf(piece, k));
        divides = known != corners.end() && known->second.second;
      }
      if (divides && lengthOf(piece, longestOf(piece)) > size_) open.push_back(i);
    }
    while (!open.empty()) {
      const Piece& piece = pieces_[open.back()];
      open.pop_back();
      const EdgeEnds edge = edgeOf(piece, longestOf(piece));
      if (!edges.insert(edge).second) continue;
      const std::vector<std::uint32_t>& users = users_.at(edge);
      open.insert(open.end(), users.begin(), users.end());
    }
    return edges;
  }

  std::uint32_t middleOf(const Piece& piece, std::size_t edge) {
    const std::uint32_t a = piece.corners[edge];
    const std::uint32_t b = piece.corners[(edge + 1) % 3];
    const auto [known, isNew] = middles_.try_emplace(edgeOf(piece, edge), static_cast<std::uint32_t>(vertices_.size()));
    if (isNew) {
      newVertices_.push_back({a, b, 0.5});
      number_.push_back(static_cast<std::uint32_t>(vertices_.size()) + kNewNumbers);
      const Vector3 middle = 0.5 * (vertices_[a] + vertices_[b]);
      vertices_.push_back(middle);
    }
    return known->second;
  }

  void divide(const std::set<EdgeEnds>& edges) {
    std::set<std::uint32_t> touched;
    for (const EdgeEnds& edge : edges) {
      for (const std::uint32_t user : users_.at(edge)) touched.insert(user);
    }
    for (const std::uint32_t i : touched) {
      std::vector<Piece> open{pieces_[i]};
      forget(i);
      bool isFirst = true;
      while (!open.empty()) {
        const Piece piece = open.back();
        open.pop_back();
        std::size_t edge = longestOf(piece);
        for (std::size_t k = 0; k < 3 && edges.count(edgeOf(piece, edge)) == 0; ++k) edge = k;
        if (edges.count(edgeOf(piece, edge)) == 0) {
          const Cover cover = piece.cover == Cover::Part ? coverOf(cornersOf(piece), piece.parent) : piece.cover;
          put({piece.corners, piece.parent, cover}, isFirst ? std::optional(i) : std::nullopt);
          isFirst = false;
          continue;
        }
        const std::uint32_t middle = middleOf(piece, edge);
        const std::uint32_t from = piece.corners[edge];
        const std::uint32_t to = piece.corners[(edge + 1) % 3];
        const std::uint32_t opposite = piece.corners[(edge + 2) % 3];
        open.push_back({{from, middle, opposite}, piece.parent, piece.cover});
        open.push_back({{middle, to, opposite}, piece.parent, piece.cover});
      }
    }
  }

  void forget(std::uint32_t i) {
    for (std::size_t k = 0; k < 3; ++k) std::erase(users_[edgeOf(pieces_[i], k)], i);
  }

  /// `at`: the number of a piece that is replaced; nothing: adds a piece.
  void put(const Piece& piece, std::optional<std::uint32_t> at) {
    if (!at) return add(piece);
    for (std::size_t i = 0; i < 3; ++i) users_[edgeOf(piece, i)].push_back(*at);
    pieces_[*at] = piece;
  }

  FacePatches patches() const {
    FacePatches found;
    found.newVertices = newVertices_;
    JoinedSets joined(pieces_.size());
    const bool states = !body_.mesh.faces.empty();
    std::map<EdgeEnds, std::uint32_t> at;  // one piece of a patch for each vertex of a surface
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      if (pieces_[i].cover != Cover::All) continue;
      const std::uint32_t region = body_.regions.of[pieces_[i].parent];
      for (const std::uint32_t corner : pieces_[i].corners) {
        const EdgeEnds key{number_[corner], states ? region : family_[region]};
        const auto [known, isNew] = at.try_emplace(key, i);
        if (!isNew) joined.join(i, known->second);
      }
    }
    std::map<std::uint32_t, std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      found.triangles.push_back(pieces_[i].corners);
      found.parents.push_back(pieces_[i].parent);
      found.patches.push_back(FacePatches::kNone);
      if (pieces_[i].cover != Cover::All) continue;
      const auto [known, isNew] = numbers.try_emplace(joined.of(i), static_cast<std::uint32_t>(found.regions.size()));
      if (isNew) found.regions.push_back(body_.regions.of[pieces_[i].parent]);
      found.patches.back() = known->second;
    }
    return found;
  }

  static constexpr std::uint32_t kNewNumbers = 0x80000000;  ///< added to the numbers of new vertices

  const PatchQuestion& question_;
  const PlacedBody& body_;
  const StopToken& stop_;
  double size_ = 0.0;  ///< metres: upper limit of pieces at the border of a patch
  std::vector<Vector3> vertices_;
  std::vector<std::uint32_t> number_;  ///< for each vertex, a number that is equal for equal positions
  std::vector<std::uint32_t> family_;  ///< family of each region
  std::vector<Piece> pieces_;
  std::map<EdgeEnds, std::vector<std::uint32_t>> users_;  ///< pieces at each edge
  std::map<EdgeEnds, std::uint32_t> middles_;
  std::vector<NewVertex> newVertices_;
};

}  // namespace

TriangleMesh FacePatches::divided(const TriangleMesh& whole) const {
  TriangleMesh mesh{vertices(whole.vertices), triangles, whole.faces, {}};
  for (const std::uint32_t parent : parents) {
    if (!whole.faceOf.empty()) mesh.faceOf.push_back(whole.faceOf[parent]);
  }
  return mesh;
}

std::optional<FacePatches> facePatchesOf(const PatchQuestion& question, const StopToken& stop) {
  const bool any = std::any_of(question.depths.begin(), question.depths.end(), [](double each) { return each > 0.0; });
  return any ? PatchFinder(question, stop).find() : std::nullopt;
}

}  // namespace glissade::evidence
