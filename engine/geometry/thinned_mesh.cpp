#include "engine/geometry/thinned_mesh.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "engine/base/in_threads.h"
#include "engine/geometry/joined_sets.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/mesh_edges.h"
#include "engine/geometry/mesh_volume.h"
#include "engine/geometry/triangle_crossing.h"

namespace glissade {
namespace {

/// Distance within which a point is on a face, in diagonals of the body's box.
constexpr double kSameSurface = 1e-9;
/// Share of the weights that is added to the least squares matrix, so that directions without a condition do not move.
constexpr double kStill = 1e-6;
/// Share of the allowance. A face without an allowance may move outwards by less. Corners that slide along a round face
/// do not stay on it exactly.
constexpr double kStays = 0.01;
/// Least height of a triangle, in diagonals of the body's box. The normal of a lower triangle is determined by
/// rounding.
constexpr double kLowest = 2e-6;
/// Number of times that the moves of corners of triangles that meet the true surface are halved. After that the corners
/// do not move.
constexpr int kMostHalvings = 8;
/// Least winding number of a point inside an open body. It is a half on either side of a single sheet.
constexpr double kInside = 0.75;
/// Number of faces that a thread processes at once.
constexpr std::size_t kAtOnce = 2048;

Triangle cornersOf(const TriangleMesh& mesh, const TriangleIndices& triangle) {
  return {mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]};
}

/// Unit normal, outwards or inwards; zero where the triangle is lower than `lowest`.
Vector3 normalOf(const Triangle& triangle, double lowest) {
  const Vector3 across = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, (triangle[(i + 1) % 3] - triangle[i]).norm());
  return across.norm() > lowest * longest ? across.stableNormalized() : Vector3(Vector3::Zero());
}

/// The least thickness found below the middle of a triangle and below three points towards its corners.
double thicknessBelow(const TriangleTree& surface, const Triangle& triangle, const Vector3& normal, double beyond) {
  const Vector3 sum = triangle[0] + triangle[1] + triangle[2];
  double least = surface.firstHit(sum / 3.0, -normal, beyond);
  for (const Vector3& corner : triangle) {
    least = std::min(least, surface.firstHit((sum + 3.0 * corner) / 6.0, -normal, beyond));
  }
  return least;
}

/// Numbers of the connected surfaces, by shared vertices.
std::vector<std::uint32_t> shellsOf(const TriangleMesh& mesh) {
  JoinedSets connected(mesh.vertices.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    connected.join(b, a);
    connected.join(c, a);
  }
  std::vector<std::uint32_t> shells;
  for (const auto& [a, b, c] : mesh.triangles) shells.push_back(connected.of(a));
  return shells;
}

/// The corners of a moved triangle whose moves are reduced where it meets a true one: the corners that the two have in
/// common, else all. A vertex that slides along the tilted facets of a chamfer may leave them; the other corners of a
/// large triangle may be far away.
std::vector<std::uint32_t> cornersToHoldBack(const TriangleIndices& moved, const TriangleIndices& met) {
  std::vector<std::uint32_t> common;
  for (const std::uint32_t vertex : moved) {
    if (std::find(met.begin(), met.end(), vertex) != met.end()) common.push_back(vertex);
  }
  return common.empty() ? std::vector<std::uint32_t>(moved.begin(), moved.end()) : common;
}

/// Indices of the triangles with three different corners, which welded() keeps, in order.
std::vector<std::uint32_t> keptTriangles(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = cornersOf(mesh, mesh.triangles[t]);
    if (a != b && b != c && c != a) kept.push_back(t);
  }
  return kept;
}

}  // namespace

std::optional<ThinnableMesh> ThinnableMesh::of(const TriangleMesh& mesh) {
  TriangleMesh joined = welded(mesh);
  if (joined.empty()) return std::nullopt;
  const double volume = signedVolume(joined);
  if (!(std::abs(volume) > 0.0)) return std::nullopt;
  std::vector<std::uint32_t> sources = keptTriangles(mesh);
  if (sources.size() != joined.triangles.size()) return std::nullopt;
  return ThinnableMesh(std::move(joined), std::move(sources), volume < 0.0 ? -1.0 : 1.0);
}

ThinnableMesh::ThinnableMesh(TriangleMesh mesh, std::vector<std::uint32_t> sources, double sense)
    : mesh_(std::move(mesh)),
      sources_(std::move(sources)),
      surface_(mesh_),
      openEdges_(unpairedEdgesOf(mesh_)),
      sense_(sense),
      corners_(mesh_.vertices.size()),
      coneVertices_(coneVertices(mesh_)),
      shells_(shellsOf(mesh_)) {
  if (openEdges_.empty()) interior_.emplace(mesh_, true);
  const std::vector<Triangle>& triangles = surface_.triangles();
  const double diagonal = boundingBox(mesh_).diagonal().norm();
  std::vector<double> thicknesses(triangles.size(), 0.0);
  faces_.resize(triangles.size());
  forEachInThreads(triangles.size(), kAtOnce, [&](std::size_t f) {
    const Vector3 normal = sense * normalOf(triangles[f], kLowest * diagonal);
    const bool flat = normal.isZero(0.0);
    if (!flat) thicknesses[f] = thicknessBelow(surface_, triangles[f], normal, kSameSurface * diagonal);
    faces_[f] = {normal, thicknesses[f]};
  });
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    const Triangle& triangle = triangles[f];
    const bool flat = faces_[f].normal.isZero(0.0);
    thickness_ = std::max(thickness_, std::isfinite(thicknesses[f]) ? thicknesses[f] : 0.0);
    for (std::size_t i = 0; i < 3 && !flat; ++i) {
      const Vector3 one = (triangle[(i + 1) % 3] - triangle[i]).stableNormalized();
      const Vector3 other = (triangle[(i + 2) % 3] - triangle[i]).stableNormalized();
      const double angle = std::atan2(one.cross(other).norm(), one.dot(other));
      corners_[mesh_.triangles[f][i]].push_back({f, angle});
    }
  }
}

std::vector<Vector3> ThinnableMesh::movesOf(const Wanted& wanted) const {
  std::vector<Vector3> moves;
  for (std::size_t vertex = 0; vertex < mesh_.vertices.size(); ++vertex) moves.push_back(moveOf(vertex, wanted));
  if (coneVertices_.empty()) return moves;
  std::vector<double> taken(mesh_.faces.size(), 0.0);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    double& most = taken[mesh_.faceOf[f]];
    most = std::max(most, std::min(wanted.allowances[f], roomOf(f, wanted)));
  }
  // A chamfer does not move where the cylinder beside it is thinned only in a patch elsewhere.
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;  // a vertex and its cylinder
  for (const ConeVertex& each : coneVertices_) edges.emplace(each.vertex, each.cylinder);
  const std::vector<double> whole = taken;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const std::uint32_t face = mesh_.faceOf[f];
    if (wanted.allowances[f] >= 0.5 * whole[face]) continue;
    for (const std::uint32_t corner : mesh_.triangles[f]) {
      if (edges.count({corner, face}) > 0) taken[face] = 0.0;
    }
  }
  moveCones(coneVertices_, taken, moves);
  return moves;
}

Vector3 ThinnableMesh::moveOf(std::size_t vertex, const Wanted& wanted) const {
  double largest = 0.0;
  for (const auto& [f, angle] : corners_[vertex]) largest = std::max(largest, wanted.allowances[f]);
  if (largest <= 0.0) return Vector3::Zero();
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Vector3 moments = Vector3::Zero();
  Vector3 mean = Vector3::Zero();
  double weights = 0.0;
  for (const auto& [f, angle] : corners_[vertex]) {
    const Face& face = faces_[f];
    mean += angle * face.normal;
    matrix += angle * face.normal * face.normal.transpose();
    moments -= angle * std::min(wanted.allowances[f], roomOf(f, wanted)) * face.normal;
    weights += angle;
  }
  if (!(weights > 0.0)) return Vector3::Zero();
  matrix.diagonal().array() += kStill * weights;
  const Vector3 least = matrix.ldlt().solve(moments);
  const Vector3 plain = againstThoseAllowed(vertex, wanted, largest);
  const bool slidesFar = least.norm() > kLongestThinning * largest;
  for (const Vector3& each : slidesFar ? std::array{plain, least} : std::array{least, plain}) {
    if (const auto move = shortened(each, vertex, wanted, largest)) return *move;
  }
  return shortened(-largest * mean.stableNormalized(), vertex, wanted, largest).value_or(Vector3::Zero());
}

/// The move of a vertex against the normals of the faces with an allowance only. At the edge of a chamfer, whose facets
/// are tilted against each other, a vertex cannot slide along all of them.
Vector3 ThinnableMesh::againstThoseAllowed(std::size_t vertex, const Wanted& wanted, double largest) const {
  Vector3 mean = Vector3::Zero();
  for (const auto& [f, angle] : corners_[vertex]) {
    if (wanted.allowances[f] > 0.0) mean += angle * faces_[f].normal;
  }
  const Vector3 direction = -mean.stableNormalized();
  double length = 0.0;
  for (const auto& [f, angle] : corners_[vertex]) {
    const double asked = std::min(wanted.allowances[f], roomOf(f, wanted));
    if (asked <= 0.0) continue;
    const double inwards = -faces_[f].normal.dot(direction);
    if (inwards * kLongestThinning * largest <= asked) return largest * direction;
    length = std::max(length, asked / inwards);
  }
  return length * direction;
}

/// The move, shortened to the room of the faces at the vertex; nothing where one of them would move outwards.
std::optional<Vector3> ThinnableMesh::shortened(const Vector3& move, std::size_t vertex, const Wanted& wanted,
                                                double largest) const {
  const double length = move.norm();
  double share = length > kLongestThinning * largest ? kLongestThinning * largest / length : 1.0;
  for (const auto& [f, angle] : corners_[vertex]) {
    const double inwards = -faces_[f].normal.dot(move);
    if (inwards < (wanted.allowances[f] > 0.0 ? 0.0 : -kStays * largest)) return std::nullopt;
    const double room = std::min(largest, roomOf(f, wanted));
    if (share * inwards > room) share = room / inwards;
  }
  return Vector3(share * move);
}

/// Vertices of the thinned triangles among these that meet the true surface. Triangles around a vertex that has not
/// moved may meet it.
std::vector<std::uint32_t> ThinnableMesh::verticesOutside(const TriangleMesh& thinned,
                                                          const std::vector<std::uint32_t>& among) const {
  std::vector<Triangle> triangles;
  for (const std::uint32_t triangle : among) triangles.push_back(cornersOf(thinned, thinned.triangles[triangle]));
  const TriangleTree after(std::move(triangles));
  const double rounding = kSameSurface * boundingBox(mesh_).diagonal().norm();
  // Several threads mark vertices at the same time. Marks are never removed, so that their order does not matter.
  std::vector<std::uint8_t> outside(mesh_.vertices.size(), 0);
  const auto isOutside = [&](std::uint32_t vertex) {
    return std::atomic_ref(outside[vertex]).load(std::memory_order_relaxed) != 0;
  };
  // Triangles that have not moved belong to the true surface, which may cross itself.
  const auto isStill = [&](const TriangleIndices& triangle) {
    return std::all_of(triangle.begin(), triangle.end(),
                       [&](std::uint32_t vertex) { return thinned.vertices[vertex] == mesh_.vertices[vertex]; });
  };
  const auto shareStillVertex = [&](const TriangleIndices& one, const TriangleIndices& other) {
    return std::any_of(one.begin(), one.end(), [&](std::uint32_t vertex) {
      return thinned.vertices[vertex] == mesh_.vertices[vertex] &&
             std::find(other.begin(), other.end(), vertex) != other.end();
    });
  };
  after.visitAllPairs(surface_, 0.0, [&](std::uint32_t i, std::uint32_t k) {
    const TriangleIndices& moved = thinned.triangles[among[i]];
    if (isStill(moved)) return;
    if (shells_[among[i]] != shells_[k] || shareStillVertex(moved, mesh_.triangles[k])) return;
    if (std::all_of(moved.begin(), moved.end(), isOutside)) return;
    double way = 0.0;
    for (const std::uint32_t v : moved) way = std::max(way, (thinned.vertices[v] - mesh_.vertices[v]).norm());
    if (!trianglesCross(after.triangles()[i], surface_.triangles()[k], std::max(rounding, kStays * way))) return;
    for (const std::uint32_t vertex : cornersToHoldBack(moved, mesh_.triangles[k])) {
      std::atomic_ref(outside[vertex]).store(1, std::memory_order_relaxed);
    }
  });
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t vertex = 0; vertex < outside.size(); ++vertex) {
    if (outside[vertex] != 0) vertices.push_back(vertex);
  }
  return vertices;
}

std::vector<std::uint32_t> ThinnableMesh::trianglesAt(const std::vector<std::uint32_t>& vertices) const {
  std::vector<bool> asked(mesh_.vertices.size(), false);
  for (const std::uint32_t vertex : vertices) asked[vertex] = true;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh_.triangles[t];
    if (asked[a] || asked[b] || asked[c]) triangles.push_back(t);
  }
  return triangles;
}

/// True if the thinned surface, which does not cross the true one, is inside. One point decides for each connected
/// surface: the middle of the face that has moved farthest, because other points may be on faces that do not move.
bool ThinnableMesh::isInside(const TriangleMesh& thinned) const {
  struct Deepest {
    double way = 0.0;
    Vector3 at = Vector3::Zero();
  };
  std::map<std::uint32_t, Deepest> deepest;
  for (std::size_t f = 0; f < thinned.triangles.size(); ++f) {
    const Triangle after = cornersOf(thinned, thinned.triangles[f]);
    const Triangle& before = surface_.triangles()[f];
    const Vector3 middle = (after[0] + after[1] + after[2]) / 3.0;
    const double way = faces_[f].normal.dot((before[0] + before[1] + before[2]) / 3.0 - middle);
    Deepest& ofShell = deepest[shells_[f]];
    if (way > ofShell.way) ofShell = {way, middle};
  }
  return std::all_of(deepest.begin(), deepest.end(), [&](const auto& shell) {
    return shell.second.way <= 0.0 || interior_->contains(shell.second.at);
  });
}

/// True if the path of a face's middle does not meet the true surface after it has left the face.
bool ThinnableMesh::isBehind(std::size_t face, const TriangleMesh& thinned) const {
  const auto middleOf = [](const Triangle& t) -> Vector3 { return (t[0] + t[1] + t[2]) / 3.0; };
  const Vector3 before = middleOf(surface_.triangles()[face]);
  const Vector3 way = middleOf(cornersOf(thinned, thinned.triangles[face])) - before;
  const double rounding = kSameSurface * surface_.box().diagonal().norm();
  if (-faces_[face].normal.dot(way) <= rounding) return true;  // the face slides along itself
  return surface_.firstHit(before, way, rounding / way.norm()) > 1.0;
}

/// True for an open surface if the path of each face that moves inwards is free, and the face that moves farthest in
/// each connected piece is inside.
bool ThinnableMesh::isInsideLocally(const TriangleMesh& thinned) const {
  TriangleMesh moved{mesh_.vertices, {}};
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < thinned.triangles.size(); ++f) {
    const TriangleIndices& triangle = thinned.triangles[f];
    const bool moves = std::any_of(triangle.begin(), triangle.end(),
                                   [&](std::uint32_t v) { return thinned.vertices[v] != mesh_.vertices[v]; });
    if (!moves || faces_[f].normal.isZero(0.0)) continue;
    if (!isBehind(f, thinned)) return false;
    moved.triangles.push_back(triangle);
    faces.push_back(f);
  }
  const std::vector<std::uint32_t> pieces = shellsOf(moved);
  std::map<std::uint32_t, std::pair<double, Vector3>> deepest;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto& [a, b, c] = surface_.triangles()[faces[i]];
    const auto& [d, e, f] = cornersOf(thinned, thinned.triangles[faces[i]]);
    const Vector3 middle = (d + e + f) / 3.0;
    auto& [most, at] = deepest[pieces[i]];
    const double way = faces_[faces[i]].normal.dot((a + b + c) / 3.0 - middle);
    if (way <= most) continue;
    most = way;
    at = middle;
  }
  return std::all_of(deepest.begin(), deepest.end(), [&](const auto& piece) {
    return piece.second.first <= 0.0 || sense_ * windingNumber(mesh_, piece.second.second) >= kInside;
  });
}

std::optional<double> ThinnableMesh::openBeside(const std::vector<double>& allowances) const {
  return openBesideFaces(ofFaces(allowances));
}

std::optional<double> ThinnableMesh::openBesideFaces(const std::vector<double>& allowances) const {
  if (openEdges_.empty()) return std::nullopt;
  std::vector<Triangle> moving;
  double largest = 0.0;
  for (std::size_t f = 0; f < allowances.size(); ++f) {
    if (allowances[f] > 0.0) moving.push_back(surface_.triangles()[f]);
    largest = std::max(largest, allowances[f]);
  }
  if (moving.empty()) return std::nullopt;
  const TriangleTree tree(std::move(moving));
  const double far = kFarFromOpening * largest;
  double nearest = far;
  for (const auto& [a, b] : openEdges_) {
    nearest = std::min(nearest, tree.distanceToSegment(mesh_.vertices[a], mesh_.vertices[b], nearest));
  }
  return nearest < far ? std::optional(nearest) : std::nullopt;
}

std::optional<TriangleMesh> ThinnableMesh::thinned(double allowance) const {
  return thinnedFaces({std::vector<double>(faces_.size(), allowance), kMostThinning});
}

std::optional<TriangleMesh> ThinnableMesh::thinned(const std::vector<double>& allowances, double share) const {
  return thinnedFaces({ofFaces(allowances), share});
}

std::vector<double> ThinnableMesh::ofFaces(const std::vector<double>& allowances) const {
  std::vector<double> faces;
  for (const std::uint32_t source : sources_) faces.push_back(allowances[source]);
  return faces;
}

std::optional<TriangleMesh> ThinnableMesh::thinnedFaces(const Wanted& wanted) const {
  if (openBesideFaces(wanted.allowances)) return std::nullopt;
  std::vector<Vector3> moves = movesOf(wanted);
  std::vector<std::uint32_t> unsure(mesh_.triangles.size());
  std::iota(unsure.begin(), unsure.end(), 0U);
  for (int round = 0; round <= 2 * kMostHalvings; ++round) {
    TriangleMesh thinned = mesh_;
    for (std::size_t vertex = 0; vertex < moves.size(); ++vertex) thinned.vertices[vertex] += moves[vertex];
    const std::vector<std::uint32_t> outside = verticesOutside(thinned, unsure);
    if (outside.empty()) {
      const bool inside = interior_ ? isInside(thinned) : isInsideLocally(thinned);
      return inside ? std::optional(std::move(thinned)) : std::nullopt;
    }
    const double share = round < kMostHalvings ? 0.5 : 0.0;
    for (const std::uint32_t vertex : outside) moves[vertex] *= share;
    unsure = trianglesAt(outside);  // the other triangles have not changed
  }
  return std::nullopt;
}

}  // namespace glissade
