#include "engine/geometry/separate_solids.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

#include "engine/geometry/mesh_volume.h"
#include "engine/geometry/triangle_tree.h"

namespace glissade {
namespace {

/// Numbers that are joined to sets.
class JoinedSets {
 public:
  explicit JoinedSets(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), std::size_t{0}); }

  std::size_t of(std::size_t one) {
    while (above_[one] != one) one = above_[one] = above_[above_[one]];
    return one;
  }
  void join(std::size_t one, std::size_t other) { above_[of(one)] = of(other); }

 private:
  std::vector<std::size_t> above_;
};

/// The connected surfaces that are turned outwards.
std::vector<TriangleMesh> solidsOf(const TriangleMesh& mesh) {
  TriangleMesh whole = welded(mesh);
  JoinedSets pieces(whole.vertices.size());
  for (const auto& [a, b, c] : whole.triangles) {
    pieces.join(a, b);
    pieces.join(b, c);
  }
  std::map<std::size_t, TriangleMesh> byPiece;
  for (const TriangleIndices& triangle : whole.triangles) {
    TriangleMesh& piece = byPiece[pieces.of(triangle[0])];
    const auto first = static_cast<std::uint32_t>(piece.vertices.size());
    for (const std::uint32_t i : triangle) piece.vertices.push_back(whole.vertices[i]);
    piece.triangles.push_back({first, first + 1, first + 2});
  }
  std::vector<TriangleMesh> solids;
  for (auto& [number, piece] : byPiece) {
    if (signedVolume(piece) > 0.0) solids.push_back(std::move(piece));
  }
  return solids;
}

bool isNear(const TriangleMesh& mesh, const TriangleTree& other, double distance) {
  return std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const Vector3& vertex) {
    return other.box().exteriorDistance(vertex) <= distance &&
           other.nearest(vertex, 2.0 * distance, distance).distance <= distance;
  });
}

}  // namespace

std::size_t separateSolids(const TriangleMesh& mesh, double touching) {
  const std::vector<TriangleMesh> solids = solidsOf(mesh);
  std::vector<TriangleTree> trees;
  for (const TriangleMesh& solid : solids) trees.emplace_back(solid);
  JoinedSets groups(solids.size());
  for (std::size_t a = 0; a < solids.size(); ++a) {
    for (std::size_t b = a + 1; b < solids.size(); ++b) {
      if (trees[a].box().exteriorDistance(trees[b].box()) > touching) continue;
      if (isNear(solids[a], trees[b], touching) || isNear(solids[b], trees[a], touching)) groups.join(a, b);
    }
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < solids.size(); ++i) count += groups.of(i) == i ? 1U : 0U;
  return count;
}

}  // namespace glissade
