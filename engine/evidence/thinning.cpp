#include "engine/evidence/thinning.h"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/evidence/open_surface.h"
#include "engine/evidence/ray_containment.h"
#include "engine/geometry/continued_cones.h"
#include "engine/geometry/joined_sets.h"
#include "engine/geometry/triangle_crossing.h"
#include "engine/geometry/triangle_tree.h"

namespace glissade::evidence {
namespace {

constexpr double kLongestMove = 2.0;
constexpr double kDamping = 1e-6;
constexpr double kFlatShare = 2e-6;
constexpr double kSameFace = 1e-9;
/// Share of the allowance: a face without an allowance that moves outwards by less stays. Corners that slide along a
/// round face do not meet it exactly.
constexpr double kStays = 0.01;
/// Corners of triangles that cross the true surface move half as far in the first rounds, and stay in the others.
constexpr int kHalvings = 8;
constexpr int kThinningRounds = 2 * kHalvings + 1;

using Corners = Triangle;

/// Share of the segment at which it crosses the triangle; infinity if it does not.
double crossing(const Vector3& from, const Vector3& to, const Corners& triangle) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const Vector3 way = to - from;
  const Vector3 u = triangle[1] - triangle[0];
  const Vector3 v = triangle[2] - triangle[0];
  const Vector3 cross = way.cross(v);
  const double determinant = u.dot(cross);
  if (determinant == 0.0) return kNone;
  const Vector3 offset = from - triangle[0];
  const double a = offset.dot(cross) / determinant;
  const Vector3 other = offset.cross(u);
  const double b = way.dot(other) / determinant;
  if (!(a >= 0.0) || !(b >= 0.0) || !(a + b <= 1.0)) return kNone;
  return v.dot(other) / determinant;
}

Box3 boxAround(const Corners& corners) {
  Box3 box(corners[0]);
  box.extend(corners[1]);
  box.extend(corners[2]);
  return box;
}

/// The triangles of a body with welded vertices, and the limits of the motion of each face and vertex.
class ThinBody {
 public:
  ThinBody(const TriangleMesh& mesh, const std::vector<double>& allowances, double share)
      : share_(share), stated_(mesh.faces) {
    std::map<std::tuple<double, double, double>, std::uint32_t> numbers;
    std::vector<std::uint32_t> numberOf;
    for (const Vector3& vertex : mesh.vertices) {
      const auto next = static_cast<std::uint32_t>(points_.size());
      const auto [at, isNew] = numbers.try_emplace({vertex.x(), vertex.y(), vertex.z()}, next);
      if (isNew) points_.push_back(vertex);
      numberOf.push_back(at->second);
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      const TriangleIndices triangle{numberOf[a], numberOf[b], numberOf[c]};
      if (std::set<std::uint32_t>(triangle.begin(), triangle.end()).size() != 3) continue;
      triangles_.push_back(triangle);
      allowances_.push_back(allowances[t]);
      if (!mesh.faceOf.empty()) faceOf_.push_back(mesh.faceOf[t]);
    }
    for (const TriangleIndices& triangle : triangles_) {
      faces_.push_back(cornersOf(triangle, points_));
      box_.extend(boxAround(faces_.back()));
    }
    tree_.emplace(faces_);
  }

  /// The thinned body; the whole body if it cannot be thinned, or is open too near.
  TriangleMesh thinned() {
    const auto openEdges = openEdgesOf(points_, triangles_);
    isOpen_ = !openEdges.empty();
    if (isOpen_ && !areFar(openEdges, faces_, allowances_)) return {points_, triangles_};
    findNormals();
    findRooms();
    findPieces();
    std::vector<Vector3> moves = movesOf();
    moveConesWithCylinders(moves);
    for (int round = 0; round < kThinningRounds; ++round) {
      TriangleMesh result{points_, triangles_};
      for (std::size_t i = 0; i < moves.size(); ++i) result.vertices[i] += moves[i];
      const std::set<std::uint32_t> bad = crossingCorners(result);
      if (bad.empty()) {
        const bool within = isOpen_ ? isWithinLocally(result) : isWithin(result);
        return within ? result : TriangleMesh{points_, triangles_};
      }
      for (const std::uint32_t i : bad) moves[i] *= round < kHalvings ? 0.5 : 0.0;
    }
    return {points_, triangles_};
  }

 private:
  /// Faces at a vertex, with their angles there.
  using Angles = std::vector<std::pair<std::size_t, double>>;

  static Corners cornersOf(const TriangleIndices& t, const std::vector<Vector3>& points) {
    return {points[t[0]], points[t[1]], points[t[2]]};
  }

  void findNormals() {
    double volume = 0.0;
    for (const auto& [a, b, c] : faces_) {
      volume += (a - box_.center()).dot((b - box_.center()).cross(c - box_.center()));
    }
    const double flat = kFlatShare * box_.diagonal().norm();
    for (const auto& [a, b, c] : faces_) {
      const Vector3 doubled = (b - a).cross(c - a);
      const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
      const bool hasNormal = doubled.norm() > flat * longest;
      normals_.push_back(hasNormal ? Vector3(doubled / doubled.norm() * (volume < 0.0 ? -1.0 : 1.0))
                                   : Vector3(Vector3::Zero()));
    }
  }

  /// One entry for each vertex: true if it belongs to a face with an allowance. Other vertices stay.
  std::vector<bool> mayMove() const {
    std::vector<bool> may(points_.size(), false);
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
      if (allowances_[f] <= 0.0) continue;
      for (const std::uint32_t i : triangles_[f]) may[i] = true;
    }
    return may;
  }

  /// Measures the thickness inwards from four points of each face, as far as it matters. A face without a movable
  /// corner needs no thickness.
  void findRooms() {
    const std::vector<bool> may = mayMove();
    const double reach = *std::max_element(allowances_.begin(), allowances_.end()) / share_;
    const double same = kSameFace * box_.diagonal().norm();
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const TriangleIndices& corners = triangles_[f];
      rooms_.push_back(share_ * reach);
      if (std::none_of(corners.begin(), corners.end(), [&](std::uint32_t i) { return may[i]; })) continue;
      const Corners& face = faces_[f];
      const Vector3 middle = (face[0] + face[1] + face[2]) / 3.0;
      double thickness = reach;
      for (const Vector3& from : {middle, Vector3(0.5 * (middle + face[0])), Vector3(0.5 * (middle + face[1])),
                                  Vector3(0.5 * (middle + face[2]))}) {
        const Vector3 to = from - reach * normals_[f];
        Box3 box(from);
        box.extend(to);
        tree_->visit(box, [&](std::uint32_t other) {
          const double hit = reach * crossing(from, to, faces_[other]);
          if (hit > same) thickness = std::min(thickness, hit);
          return true;
        });
      }
      rooms_.back() = share_ * thickness;
    }
  }

  std::vector<Vector3> movesOf() const {
    std::vector<Angles> around(points_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (normals_[f].isZero(0.0)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const Vector3 one = (faces_[f][(i + 1) % 3] - faces_[f][i]).normalized();
        const Vector3 other = (faces_[f][(i + 2) % 3] - faces_[f][i]).normalized();
        around[triangles_[f][i]].emplace_back(f, std::atan2(one.cross(other).norm(), one.dot(other)));
      }
    }
    std::vector<Vector3> moves;
    moves.reserve(around.size());
    for (const auto& faces : around) moves.push_back(moveOf(faces));
    return moves;
  }

  /// Moves a chamfer's vertices so that it ends where its thinned cylinder does. A chamfer stays if the cylinder beside
  /// it is not thinned there.
  void moveConesWithCylinders(std::vector<Vector3>& moves) const {
    std::vector<double> taken(stated_.size(), 0.0);
    for (std::size_t f = 0; f < faceOf_.size(); ++f) {
      taken[faceOf_[f]] = std::max(taken[faceOf_[f]], std::min(allowances_[f], rooms_[f]));
    }
    const std::vector<ConeVertex> cones = coneVertices({points_, triangles_, stated_, faceOf_});
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;  // a vertex and its cylinder
    for (const ConeVertex& each : cones) edges.emplace(each.vertex, each.cylinder);
    const std::vector<double> whole = taken;
    for (std::size_t f = 0; f < faceOf_.size() && !edges.empty(); ++f) {
      if (allowances_[f] >= 0.5 * whole[faceOf_[f]]) continue;
      for (const std::uint32_t corner : triangles_[f]) {
        if (edges.count({corner, faceOf_[f]}) > 0) taken[faceOf_[f]] = 0.0;
      }
    }
    moveCones(cones, taken, moves);
  }

  Vector3 moveOf(const Angles& faces) const {
    double allowance = 0.0;
    for (const auto& [f, angle] : faces) allowance = std::max(allowance, allowances_[f]);
    if (allowance == 0.0) return Vector3::Zero();
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    Vector3 mean = Vector3::Zero();
    Vector3 right = Vector3::Zero();
    double angles = 0.0;
    for (const auto& [f, angle] : faces) {
      sum += angle * normals_[f] * normals_[f].transpose();
      right += angle * std::min(allowances_[f], rooms_[f]) * normals_[f];
      mean += angle * normals_[f];
      angles += angle;
    }
    const Eigen::Matrix3d damped = sum + kDamping * angles * Eigen::Matrix3d::Identity();
    const Vector3 sliding = -damped.colPivHouseholderQr().solve(right);
    const Vector3 across = acrossAllowed(faces, allowance);
    std::array<Vector3, 2> moves{sliding, across};
    if (sliding.norm() > kLongestMove * allowance) std::swap(moves[0], moves[1]);
    for (const Vector3& move : moves) {
      if (const double share = shareOf(move, faces, allowance); share >= 0.0) return share * move;
    }
    const Vector3 plain = mean.norm() > 0.0 ? Vector3(-allowance * mean / mean.norm()) : Vector3(Vector3::Zero());
    return std::max(0.0, shareOf(plain, faces, allowance)) * plain;
  }

  /// The move against the faces with an allowance only, so that each moves by its allowance. The facets of a chamfer
  /// beside them are not in one plane, so a corner cannot slide along all of them.
  Vector3 acrossAllowed(const Angles& faces, double allowance) const {
    Vector3 sum = Vector3::Zero();
    for (const auto& [f, angle] : faces) sum += (allowances_[f] > 0.0 ? angle : 0.0) * normals_[f];
    if (!(sum.norm() > 0.0)) return Vector3::Zero();
    const Vector3 inwards = -sum / sum.norm();
    double way = 0.0;
    for (const auto& [f, angle] : faces) {
      const double wanted = std::min(allowances_[f], rooms_[f]);
      const double cosine = -normals_[f].dot(inwards);
      if (wanted <= 0.0) continue;
      if (cosine <= wanted / (kLongestMove * allowance)) return allowance * inwards;
      way = std::max(way, wanted / cosine);
    }
    return way * inwards;
  }

  /// Share of the move that the faces permit; negative if a face would move outwards.
  double shareOf(const Vector3& move, const Angles& faces, double allowance) const {
    double share = std::min(1.0, kLongestMove * allowance / std::max(move.norm(), 1e-300));
    for (const auto& [f, angle] : faces) {
      const double inwards = -normals_[f].dot(move);
      if (inwards < (allowances_[f] > 0.0 ? 0.0 : -kStays * allowance)) return -1.0;
      if (inwards > 0.0) share = std::min(share, std::min(allowance, rooms_[f]) / inwards);
    }
    return share;
  }

  /// Gives one number to all connected vertices.
  void findPieces() {
    JoinedSets connected(points_.size());
    for (const auto& [a, b, c] : triangles_) {
      connected.join(b, a);
      connected.join(c, a);
    }
    piece_ = std::move(connected).all();
  }

  std::set<std::uint32_t> crossingCorners(const TriangleMesh& thin) const {
    std::set<std::uint32_t> bad;
    const double rounding = kSameFace * box_.diagonal().norm();
    for (const TriangleIndices& moved : thin.triangles) {
      double way = 0.0;
      for (const std::uint32_t i : moved) way = std::max(way, (thin.vertices[i] - points_[i]).norm());
      if (way == 0.0) continue;
      const double near = std::max(rounding, kStays * way);
      const Corners corners = cornersOf(moved, thin.vertices);
      const Box3 box = boxAround(corners);
      tree_->visit(box, [&](std::uint32_t f) {
        if (piece_[moved[0]] != piece_[triangles_[f][0]]) return true;
        if (meetAtStillCorner(moved, triangles_[f], thin) || !trianglesCross(corners, faces_[f], near)) return true;
        addCornersToHoldBack(moved, triangles_[f], bad);
        return true;
      });
    }
    return bad;
  }

  /// Corners that two faces share leave the face along which they slide; other corners may be far away from it.
  static void addCornersToHoldBack(const TriangleIndices& moved, const TriangleIndices& face,
                                   std::set<std::uint32_t>& bad) {
    bool shared = false;
    for (const std::uint32_t i : moved) {
      if (std::find(face.begin(), face.end(), i) == face.end()) continue;
      bad.insert(i);
      shared = true;
    }
    if (!shared) bad.insert(moved.begin(), moved.end());
  }

  bool meetAtStillCorner(const TriangleIndices& moved, const TriangleIndices& face, const TriangleMesh& thin) const {
    return std::any_of(face.begin(), face.end(), [&](std::uint32_t i) {
      return std::find(moved.begin(), moved.end(), i) != moved.end() && thin.vertices[i] == points_[i];
    });
  }

  /// For surfaces that do not cross, one point of each connected surface decides. It is the centre of the face that has
  /// moved farthest inwards, because other points may be on faces that stay.
  bool isWithin(const TriangleMesh& thin) const {
    std::map<std::uint32_t, std::pair<double, Vector3>> deepest;
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
      const auto& [a, b, c] = triangles_[f];
      const Vector3 middle = (thin.vertices[a] + thin.vertices[b] + thin.vertices[c]) / 3.0;
      const double way = normals_[f].dot((faces_[f][0] + faces_[f][1] + faces_[f][2]) / 3.0 - middle);
      auto& [most, at] = deepest[piece_[a]];
      if (way <= most) continue;
      most = way;
      at = middle;
    }
    const RaySolid body(TriangleMesh{points_, triangles_});
    return std::all_of(deepest.begin(), deepest.end(),
                       [&](const auto& each) { return each.second.first <= 0.0 || body.contains(each.second.second); });
  }

  bool isWithinLocally(const TriangleMesh& thin) const {
    std::vector<Corners> after;
    for (const TriangleIndices& t : triangles_) after.push_back(cornersOf(t, thin.vertices));
    return isBehind({triangles_, faces_, after, normals_});
  }

  double share_;  ///< share of the thickness below a face that the face may lose
  std::vector<Vector3> points_;
  std::vector<TriangleIndices> triangles_;
  std::vector<double> allowances_;  ///< one entry for each triangle
  const std::vector<SurfaceFace>& stated_;
  std::vector<std::uint32_t> faceOf_;  ///< stated face of each triangle, if the file states faces
  std::vector<Corners> faces_;
  std::optional<TriangleTree> tree_;  ///< tree of `faces_`
  Box3 box_;
  std::vector<Vector3> normals_;  ///< outwards; zero for a face with next to no area
  std::vector<double> rooms_;
  bool isOpen_ = false;               ///< the surface has open edges
  std::vector<std::uint32_t> piece_;  ///< for each vertex, a number that is equal within a connected surface
};

}  // namespace

TriangleMesh thinned(const TriangleMesh& mesh, const std::vector<double>& allowances, double share) {
  const bool nothing = std::none_of(allowances.begin(), allowances.end(), [](double each) { return each > 0.0; });
  if (nothing) return mesh;
  return ThinBody(mesh, allowances, share).thinned();
}

}  // namespace glissade::evidence
