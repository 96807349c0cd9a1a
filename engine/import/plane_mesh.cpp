#include "engine/import/plane_mesh.h"

#include <map>
#include <utility>

namespace glissade {
namespace {

/// True if the angles at c and d opposite to the side from a to b exceed two right angles together.
bool areTogetherFlat(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
  constexpr double kRounding = 1e-9;
  const PlanePoint ca = (a - c).normalized();
  const PlanePoint cb = (b - c).normalized();
  const PlanePoint da = (a - d).normalized();
  const PlanePoint db = (b - d).normalized();
  return crossProduct(ca, cb) * db.dot(da) + ca.dot(cb) * crossProduct(db, da) < -kRounding;
}

}  // namespace

PlaneMesh::PlaneMesh(std::vector<PlanePoint> points, std::vector<TriangleIndices> triangles)
    : points_(std::move(points)), triangles_(std::move(triangles)) {
  findNeighbours();
}

void PlaneMesh::findNeighbours() {
  neighbours_.assign(triangles_.size(), {kNone, kNone, kNone});
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Side>> sides;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) sides[{triangles_[t][i], triangles_[t][(i + 1) % 3]}].push_back({t, i});
  }
  for (const auto& [ends, uses] : sides) {
    const auto other = sides.find({ends.second, ends.first});
    if (uses.size() != 1 || other == sides.end() || other->second.size() != 1) continue;
    neighbours_[uses.front().triangle][uses.front().corner] = other->second.front().triangle;
  }
}

PlaneMesh::Side PlaneMesh::otherSideOf(Side side) const {
  const std::size_t other = neighbours_[side.triangle][side.corner];
  const std::uint32_t end = triangles_[side.triangle][(side.corner + 1) % 3];
  std::size_t corner = 0;
  while (triangles_[other][corner] != end || neighbours_[other][corner] != side.triangle) {
    if (++corner == 3) return {kNone, 0};
  }
  return {other, corner};
}

void PlaneMesh::replaceNeighbour(std::size_t of, std::size_t old, std::size_t by) {
  if (of == kNone) return;
  for (std::size_t& neighbour : neighbours_[of]) {
    if (neighbour != old) continue;
    neighbour = by;
    return;
  }
}

bool PlaneMesh::isToFlip(Side side) const {
  if (neighbours_[side.triangle][side.corner] == kNone) return false;
  const Side other = otherSideOf(side);
  if (other.triangle == kNone) return false;
  const TriangleIndices& t = triangles_[side.triangle];
  const PlanePoint& a = points_[t[side.corner]];
  const PlanePoint& b = points_[t[(side.corner + 1) % 3]];
  const PlanePoint& c = points_[t[(side.corner + 2) % 3]];
  const PlanePoint& d = points_[triangles_[other.triangle][(other.corner + 2) % 3]];
  if (!(doubleArea(c, a, d) > 0.0 && doubleArea(d, b, c) > 0.0)) return false;
  return doubleArea(a, b, c) <= 0.0 || doubleArea(b, a, d) <= 0.0 || areTogetherFlat(a, b, c, d);
}

void PlaneMesh::flip(Side side) {
  const Side other = otherSideOf(side);
  const std::size_t t = side.triangle;
  const std::size_t u = other.triangle;
  const std::uint32_t a = triangles_[t][side.corner];
  const std::uint32_t b = triangles_[t][(side.corner + 1) % 3];
  const std::uint32_t c = triangles_[t][(side.corner + 2) % 3];
  const std::uint32_t d = triangles_[u][(other.corner + 2) % 3];
  const std::size_t beyondBc = neighbours_[t][(side.corner + 1) % 3];
  const std::size_t beyondCa = neighbours_[t][(side.corner + 2) % 3];
  const std::size_t beyondAd = neighbours_[u][(other.corner + 1) % 3];
  const std::size_t beyondDb = neighbours_[u][(other.corner + 2) % 3];
  triangles_[t] = {c, a, d};
  neighbours_[t] = {beyondCa, beyondAd, u};
  triangles_[u] = {d, b, c};
  neighbours_[u] = {beyondDb, beyondBc, t};
  replaceNeighbour(beyondAd, u, t);
  replaceNeighbour(beyondBc, t, u);
}

void PlaneMesh::makeDelaunay() {
  std::vector<Side> sides;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) sides.push_back({t, i});
  }
  makeDelaunayFrom(std::move(sides));
}

void PlaneMesh::makeDelaunayFrom(std::vector<Side> sides) {
  // Rounding may cause cyclic flips.
  std::size_t left = 100 * (triangles_.size() + sides.size());
  while (!sides.empty() && left > 0) {
    const Side side = sides.back();
    sides.pop_back();
    if (!isToFlip(side)) continue;
    --left;
    const std::size_t other = neighbours_[side.triangle][side.corner];
    flip(side);
    for (std::size_t i = 0; i < 3; ++i) {
      sides.push_back({side.triangle, i});
      sides.push_back({other, i});
    }
  }
}

bool PlaneMesh::split(std::size_t triangle) {
  Side side{triangle, kNone};
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double length = (points_[triangles_[triangle][(i + 1) % 3]] - points_[triangles_[triangle][i]]).norm();
    if (neighbours_[triangle][i] == kNone || otherSideOf({triangle, i}).triangle == kNone || length <= longest)
      continue;
    longest = length;
    side.corner = i;
  }
  if (side.corner == kNone) return false;
  const Side other = otherSideOf(side);
  const std::size_t t = side.triangle;
  const std::size_t u = other.triangle;
  const std::uint32_t a = triangles_[t][side.corner];
  const std::uint32_t b = triangles_[t][(side.corner + 1) % 3];
  const std::uint32_t c = triangles_[t][(side.corner + 2) % 3];
  const std::uint32_t d = triangles_[u][(other.corner + 2) % 3];
  const std::size_t beyondBc = neighbours_[t][(side.corner + 1) % 3];
  const std::size_t beyondCa = neighbours_[t][(side.corner + 2) % 3];
  const std::size_t beyondAd = neighbours_[u][(other.corner + 1) % 3];
  const std::size_t beyondDb = neighbours_[u][(other.corner + 2) % 3];
  const auto m = static_cast<std::uint32_t>(points_.size());
  points_.emplace_back(0.5 * (points_[a] + points_[b]));
  const std::size_t t2 = triangles_.size();
  const std::size_t u2 = t2 + 1;
  triangles_[t] = {a, m, c};
  neighbours_[t] = {u, t2, beyondCa};
  triangles_[u] = {m, a, d};
  neighbours_[u] = {t, beyondAd, u2};
  triangles_.push_back({m, b, c});
  neighbours_.push_back({u2, beyondBc, t});
  triangles_.push_back({b, m, d});
  neighbours_.push_back({t2, u, beyondDb});
  replaceNeighbour(beyondBc, t, t2);
  replaceNeighbour(beyondDb, u, u2);
  std::vector<Side> sides;
  for (const std::size_t changed : {t, u, t2, u2}) {
    for (std::size_t i = 0; i < 3; ++i) sides.push_back({changed, i});
  }
  makeDelaunayFrom(std::move(sides));
  return true;
}

}  // namespace glissade
