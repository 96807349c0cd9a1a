#include "engine/evidence/open_surface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace glissade::evidence {
namespace {

/// Least distance between an open edge and a face that moves, in allowances.
constexpr double kFar = 9.0;
/// Least share of directions that meet the surface from within, at a point inside; half of them do at a sheet.
constexpr double kFromWithin = 0.7;
constexpr int kDirections = 128;
/// Share of a displacement that is skipped at its beginning, which is on the moving face.
constexpr double kBeginning = 1e-3;

Vector3 centroidOf(const Triangle& t) { return (t[0] + t[1] + t[2]) / 3.0; }

/// Directions that are spread evenly over the sphere, along a spiral.
std::vector<Vector3> directions() {
  std::vector<Vector3> all;
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < kDirections; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / kDirections;
    const double across = std::sqrt(1.0 - z * z);
    all.emplace_back(across * std::cos(golden * i), across * std::sin(golden * i), z);
  }
  return all;
}

/// 1 if the ray passes the triangle towards the side from which its corners turn left, -1 if it comes from that side, 0
/// if it misses the triangle.
int passage(const Vector3& from, const Vector3& direction, const Triangle& t) {
  const Vector3 a = t[0] - from;
  const Vector3 b = t[1] - from;
  const Vector3 c = t[2] - from;
  const double ab = direction.dot(a.cross(b));
  const double bc = direction.dot(b.cross(c));
  const double ca = direction.dot(c.cross(a));
  const bool left = ab > 0.0 && bc > 0.0 && ca > 0.0;
  const bool right = ab < 0.0 && bc < 0.0 && ca < 0.0;
  if (!left && !right) return 0;
  const double height = a.dot((b - a).cross(c - a));
  if (left) return height > 0.0 ? 1 : 0;
  return height < 0.0 ? -1 : 0;
}

/// Number of exits minus entries of rays in all directions, divided by the number of directions.
double metFromWithin(const Vector3& from, const std::vector<Triangle>& faces) {
  int met = 0;
  for (const Vector3& direction : directions()) {
    for (const Triangle& face : faces) met += passage(from, direction, face);
  }
  return static_cast<double>(met) / kDirections;
}

class Behind {
 public:
  explicit Behind(const MovedSurface& surface) : surface_(surface) {
    for (const Triangle& t : surface.before) boxes_.push_back(Box3(t[0]).extend(t[1]).extend(t[2]));
    for (std::uint32_t f = 0; f < surface.before.size(); ++f) {
      if (surface.before[f] != surface.after[f] && !surface.normals[f].isZero(0.0)) moved_.push_back(f);
    }
  }

  bool isBehind() const {
    const bool free = std::all_of(moved_.begin(), moved_.end(), [this](std::uint32_t f) { return isWayFree(f); });
    if (!free) return false;
    const double sense = turnsLeft() ? 1.0 : -1.0;
    const auto farthest = farthestOfPieces();
    return std::all_of(farthest.begin(), farthest.end(), [&](const auto& piece) {
      const auto& [way, f] = piece.second;
      return way <= 0.0 || sense * metFromWithin(centroidOf(surface_.after[f]), surface_.before) >= kFromWithin;
    });
  }

 private:
  double inwards(std::uint32_t f) const {
    return surface_.normals[f].dot(centroidOf(surface_.before[f]) - centroidOf(surface_.after[f]));
  }

  /// True if corners turn left about the outward normals; this is equal for all triangles.
  bool turnsLeft() const {
    if (moved_.empty()) return true;
    const Triangle& t = surface_.before[moved_.front()];
    return surface_.normals[moved_.front()].dot((t[1] - t[0]).cross(t[2] - t[0])) > 0.0;
  }

  bool isWayFree(std::uint32_t f) const {
    const Vector3 to = centroidOf(surface_.after[f]);
    const Vector3 from = centroidOf(surface_.before[f]) + kBeginning * (to - centroidOf(surface_.before[f]));
    const double way = inwards(f);
    if (way <= 1e-3 * (to - from).norm()) return true;  // the face moves along its plane
    const double near = 1e-6 * way;
    const Box3 box = Box3(from).extend(to);
    for (std::uint32_t other = 0; other < boxes_.size(); ++other) {
      if (other == f || !box.intersects(boxes_[other])) continue;
      if (squaredSegmentDistance(from, to, surface_.before[other]) < near * near) return false;
    }
    return true;
  }

  /// For each group of moved faces that are connected by corners: the largest displacement, and its face.
  std::map<std::uint32_t, std::pair<double, std::uint32_t>> farthestOfPieces() const {
    std::map<std::uint32_t, std::uint32_t> link;
    const auto rootOf = [&](std::uint32_t corner) {
      link.try_emplace(corner, corner);
      while (link[corner] != corner) corner = link[corner];
      return corner;
    };
    for (const std::uint32_t f : moved_) {
      const auto& [a, b, c] = surface_.triangles[f];
      const std::uint32_t root = rootOf(a);
      link[rootOf(b)] = root;
      link[rootOf(c)] = root;
    }
    std::map<std::uint32_t, std::pair<double, std::uint32_t>> farthest;
    for (const std::uint32_t f : moved_) {
      auto& [way, face] = farthest[rootOf(surface_.triangles[f][0])];
      if (inwards(f) <= way) continue;
      way = inwards(f);
      face = f;
    }
    return farthest;
  }

  const MovedSurface& surface_;
  std::vector<Box3> boxes_;
  std::vector<std::uint32_t> moved_;
};

}  // namespace

std::vector<std::array<Vector3, 2>> openEdgesOf(const std::vector<Vector3>& points,
                                                const std::vector<TriangleIndices>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const TriangleIndices& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i];
      const std::uint32_t b = t[(i + 1) % 3];
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  std::vector<std::array<Vector3, 2>> edges;
  for (const auto& [edge, rest] : balance) {
    if (rest != 0) edges.push_back({points[edge.first], points[edge.second]});
  }
  return edges;
}

bool areFar(const std::vector<std::array<Vector3, 2>>& openEdges, const std::vector<Triangle>& faces,
            const std::vector<double>& allowances) {
  const double far = kFar * *std::max_element(allowances.begin(), allowances.end());
  std::vector<Box3> boxes;
  for (const Triangle& t : faces) boxes.push_back(Box3(t[0]).extend(t[1]).extend(t[2]));
  for (const auto& [a, b] : openEdges) {
    Box3 box = Box3(a).extend(b);
    box.min().array() -= far;
    box.max().array() += far;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (allowances[f] <= 0.0 || !box.intersects(boxes[f])) continue;
      if (squaredSegmentDistance(a, b, faces[f]) < far * far) return false;
    }
  }
  return true;
}

bool isBehind(const MovedSurface& surface) { return Behind(surface).isBehind(); }

}  // namespace glissade::evidence
