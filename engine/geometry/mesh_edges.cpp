#include "engine/geometry/mesh_edges.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "engine/base/reserve_filled.h"

namespace glissade {
namespace {

/// The uses of all edges, by their lower vertex. An entry is twice the other vertex, plus 1 where a triangle goes from
/// the lower to the higher vertex.
struct EdgeUses {
  std::vector<std::uint64_t> uses;
  std::vector<std::uint32_t> begins;  ///< index of the first use of each vertex, and the end

  explicit EdgeUses(const TriangleMesh& mesh) : begins(mesh.vertices.size() + 2, 0) {
    reserveFilled(uses, 3 * mesh.triangles.size());
    uses.resize(3 * mesh.triangles.size());
    // Counts are stored two places further, so that filling moves each beginning to its place.
    visit(mesh, [&](std::uint32_t lower, std::uint64_t) { ++begins[lower + 2]; });
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    visit(mesh, [&](std::uint32_t lower, std::uint64_t use) { uses[begins[lower + 1]++] = use; });
  }

 private:
  template <class Take>
  static void visit(const TriangleMesh& mesh, const Take& take) {
    for (const auto& triangle : mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = triangle[i];
        const std::uint32_t to = triangle[(i + 1) % 3];
        take(std::min(from, to), 2 * std::uint64_t{std::max(from, to)} + (from < to ? 1 : 0));
      }
    }
  }
};

/// Calls `take` with each edge's lower and higher vertex, the number of its uses, and the number of uses from the lower
/// to the higher vertex.
template <class Take>
void visitEdges(const TriangleMesh& mesh, const Take& take) {
  EdgeUses edges(mesh);
  for (std::uint32_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    auto first = edges.uses.begin() + static_cast<std::ptrdiff_t>(edges.begins[vertex]);
    const auto end = edges.uses.begin() + static_cast<std::ptrdiff_t>(edges.begins[vertex + 1]);
    std::sort(first, end);
    while (first != end) {
      const std::uint64_t higher = *first / 2;
      std::size_t count = 0;
      std::size_t forward = 0;
      for (; first != end && *first / 2 == higher; ++first) {
        ++count;
        forward += *first % 2;
      }
      take(vertex, static_cast<std::uint32_t>(higher), count, forward);
    }
  }
}

}  // namespace

EdgeFacts edgeFactsOf(const TriangleMesh& mesh) {
  EdgeFacts facts;
  visitEdges(mesh, [&](std::uint32_t, std::uint32_t, std::size_t count, std::size_t forward) {
    if (count % 2 != 0) ++facts.open;
    if (2 * forward != count) facts.consistentlyOriented = false;
  });
  return facts;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> unpairedEdgesOf(const TriangleMesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> unpaired;
  visitEdges(mesh, [&](std::uint32_t lower, std::uint32_t higher, std::size_t count, std::size_t forward) {
    if (2 * forward != count) unpaired.emplace_back(lower, higher);
  });
  return unpaired;
}

}  // namespace glissade
