#include "engine/geometry/separate_solids.h"

#include <cstdint>
#include <map>
#include <vector>

#include "engine/geometry/joined_sets.h"
#include "engine/geometry/mesh_volume.h"
#include "engine/geometry/triangle_tree.h"

namespace glissade {
namespace {

/// The connected surfaces that are turned outwards.
std::vector<TriangleMesh> solidsOf(const TriangleMesh& mesh) {
  TriangleMesh whole = welded(mesh);
  JoinedSets pieces(whole.vertices.size());
  for (const auto& [a, b, c] : whole.triangles) {
    pieces.join(a, b);
    pieces.join(b, c);
  }
  std::map<std::uint32_t, TriangleMesh> byPiece;
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

bool areNear(const TriangleTree& one, const TriangleTree& other, double distance) {
  bool isFound = false;
  one.visitPairs(other, distance, [&](std::uint32_t i, std::uint32_t k) {
    const Triangle& a = one.triangles()[i];
    const Triangle& b = other.triangles()[k];
    isFound = trianglesMeet(a, b) || triangleDistance(a, b).squared <= distance * distance;
    return !isFound;
  });
  return isFound;
}

}  // namespace

std::size_t separateSolids(const TriangleMesh& mesh, double touching) {
  std::vector<TriangleTree> solids;
  for (const TriangleMesh& solid : solidsOf(mesh)) solids.emplace_back(solid);
  JoinedSets groups(solids.size());
  for (std::uint32_t a = 0; a < solids.size(); ++a) {
    for (std::uint32_t b = a + 1; b < solids.size(); ++b) {
      if (areNear(solids[a], solids[b], touching)) groups.join(a, b);
    }
  }
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < solids.size(); ++i) count += groups.of(i) == i ? 1U : 0U;
  return count;
}

}  // namespace glissade
