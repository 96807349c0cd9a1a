#include "engine/import/hole_closing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "engine/import/formats/polygon_triangulation.h"

namespace glissade {
namespace {

constexpr double kPlanar = 1e-4;
// The time is quadratic in both limits.
constexpr std::size_t kMostCorners = 10'000;  ///< corners of a hole
constexpr std::size_t kMostHoles = 10'000;

using Loop = std::vector<std::uint32_t>;  ///< vertices in the sense of the cover

/// A hole with a planar edge.
struct PlanarHole {
  Loop loop;
  Box3 box;
  Vector3 normal;  ///< unit
  Vector3 middle;
};

struct Loops {
  std::vector<Loop> loops;
  std::size_t others = 0;  ///< holes that meet in a vertex, counted once for each such vertex
};

/// Edges with a triangle on one side only, from vertex to vertex, against the sense of their triangles.
std::multimap<std::uint32_t, std::uint32_t> openEdges(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const TriangleIndices& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) ++uses[{t[i], t[(i + 1) % 3]}];
  }
  std::multimap<std::uint32_t, std::uint32_t> open;
  for (const auto& [edge, count] : uses) {
    if (uses.count({edge.second, edge.first}) == 0 && count == 1) open.emplace(edge.second, edge.first);
  }
  return open;
}

Loops loopsOf(const TriangleMesh& mesh) {
  auto open = openEdges(mesh);
  Loops found;
  while (!open.empty()) {
    Loop loop;
    bool simple = true;
    std::uint32_t at = open.begin()->first;
    for (auto next = open.find(at); next != open.end(); next = open.find(at)) {
      simple = simple && open.count(at) == 1;
      loop.push_back(at);
      at = next->second;
      open.erase(next);
    }
    simple = simple && at == loop.front() && loop.size() > 2 && loop.size() <= kMostCorners;
    if (simple) {
      found.loops.push_back(std::move(loop));
    } else {
      ++found.others;
    }
  }
  return found;
}

std::vector<Vector3> cornersOf(const Loop& loop, const TriangleMesh& mesh) {
  std::vector<Vector3> corners;
  corners.reserve(loop.size());
  for (const std::uint32_t vertex : loop) corners.push_back(mesh.vertices[vertex]);
  return corners;
}

std::optional<PlanarHole> planarHole(const Loop& loop, const TriangleMesh& mesh) {
  PlanarHole hole{loop, {}, Vector3::Zero(), Vector3::Zero()};
  const std::vector<Vector3> corners = cornersOf(loop, mesh);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    hole.box.extend(corners[i]);
    hole.middle += corners[i] / static_cast<double>(corners.size());
    if (i + 1 < corners.size()) hole.normal += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
  }
  if (hole.normal.isZero(0.0)) return std::nullopt;
  hole.normal.normalize();
  const double most = kPlanar * hole.box.diagonal().norm();
  const bool planar = std::all_of(corners.begin(), corners.end(), [&](const Vector3& corner) {
    return std::abs(hole.normal.dot(corner - hole.middle)) <= most;
  });
  return planar ? std::optional(std::move(hole)) : std::nullopt;
}

/// True if the holes may be the two edges of a pipe's end: covers of both would close the bore.
bool mayBeARing(const PlanarHole& a, const PlanarHole& b) {
  const double most = kPlanar * a.box.merged(b.box).diagonal().norm();
  return a.box.intersects(b.box) && std::abs(std::abs(a.normal.dot(b.normal)) - 1.0) < kPlanar &&
         std::abs(a.normal.dot(b.middle - a.middle)) <= most;
}

}  // namespace

ClosedHoles withPlanarHolesClosed(const TriangleMesh& mesh) {
  const Loops found = loopsOf(mesh);
  ClosedHoles result{mesh, 0, found.others};
  if (found.loops.size() > kMostHoles) return {mesh, 0, found.others + found.loops.size()};
  std::vector<PlanarHole> holes;
  for (const Loop& loop : found.loops) {
    if (auto hole = planarHole(loop, mesh)) {
      holes.push_back(std::move(*hole));
    } else {
      ++result.left;
    }
  }
  for (const PlanarHole& hole : holes) {
    const bool ring = std::any_of(holes.begin(), holes.end(),
                                  [&](const PlanarHole& other) { return &other != &hole && mayBeARing(hole, other); });
    const auto cover = ring ? std::nullopt : triangulatePolygon(cornersOf(hole.loop, mesh));
    if (!cover) {
      ++result.left;
      continue;
    }
    ++result.closed;
    for (const TriangleIndices& t : *cover) {
      result.mesh.triangles.push_back({hole.loop[t[0]], hole.loop[t[1]], hole.loop[t[2]]});
    }
  }
  return result;
}

}  // namespace glissade
