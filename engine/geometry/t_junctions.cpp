#include "engine/geometry/t_junctions.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace glissade {
namespace {

constexpr double kMostOff = 2e-6;
constexpr double kMostOffShare = 1e-3;
/// Most open edges. Every open edge is compared with every vertex of an open edge, which takes too long for more.
constexpr std::size_t kMostOpenEdges = 5000;
/// Number of passes. A triangle has three edges, each of which is divided in its own pass.
constexpr int kPasses = 4;

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

std::set<DirectedEdge> openEdgesOf(const TriangleMesh& mesh) {
  std::map<DirectedEdge, int> uses;
  for (const auto& [a, b, c] : mesh.triangles) {
    for (const DirectedEdge& edge : {DirectedEdge{a, b}, {b, c}, {c, a}}) {
      ++uses[edge];
      --uses[{edge.second, edge.first}];
    }
  }
  std::set<DirectedEdge> open;
  for (const auto& [edge, count] : uses) {
    if (count > 0) open.insert(edge);
  }
  return open;
}

class TJunctions {
 public:
  explicit TJunctions(const TriangleMesh& mesh) : result_{mesh, 0, 0.0} {}

  std::optional<ClosedAtTJunctions> close() {
    std::set<DirectedEdge> open = openEdgesOf(result_.mesh);
    if (open.empty() || open.size() > kMostOpenEdges) return std::nullopt;
    for (int pass = 0; pass < kPasses && !open.empty(); ++pass) {
      if (!divide(open)) return std::nullopt;
      open = openEdgesOf(result_.mesh);
    }
    return open.empty() ? std::optional(std::move(result_)) : std::nullopt;
  }

 private:
  /// Divides the first divisible edge of each triangle; false where there is none.
  bool divide(const std::set<DirectedEdge>& open) {
    std::set<std::uint32_t> ends;
    for (const auto& [a, b] : open) ends.insert({a, b});
    std::vector<TriangleIndices> triangles;
    bool divided = false;
    for (const TriangleIndices& triangle : result_.mesh.triangles) {
      std::vector<std::uint32_t> chain;
      std::uint32_t apex = 0;
      for (std::size_t i = 0; i < 3 && chain.empty(); ++i) {
        const DirectedEdge edge{triangle[i], triangle[(i + 1) % 3]};
        apex = triangle[(i + 2) % 3];
        if (open.contains(edge)) chain = chainOf(edge, apex, ends);
      }
      if (chain.empty()) {
        triangles.push_back(triangle);
        continue;
      }
      divided = true;
      ++result_.edges;
      for (std::size_t i = 0; i + 1 < chain.size(); ++i) triangles.push_back({chain[i], chain[i + 1], apex});
    }
    result_.mesh.triangles = std::move(triangles);
    return divided;
  }

  /// The vertices on an edge from its beginning to its end; empty where there is none.
  std::vector<std::uint32_t> chainOf(const DirectedEdge& edge, std::uint32_t apex,
                                     const std::set<std::uint32_t>& ends) {
    const std::vector<Vector3>& vertices = result_.mesh.vertices;
    const Vector3& from = vertices[edge.first];
    const double length = (vertices[edge.second] - from).norm();
    const Vector3 direction = (vertices[edge.second] - from) / length;
    std::vector<std::pair<double, std::uint32_t>> between;
    for (const std::uint32_t end : ends) {
      const Vector3 p = vertices[end] - from;
      const double along = p.dot(direction);
      const double off = (p - along * direction).norm();
      const bool isOn = along > 0.0 && along < length && off <= std::min(kMostOff, kMostOffShare * length);
      if (!isOn || end == edge.first || end == edge.second || end == apex) continue;
      between.emplace_back(along, end);
      result_.moved = std::max(result_.moved, off);
    }
    if (between.empty()) return {};
    std::sort(between.begin(), between.end());
    std::vector<std::uint32_t> chain{edge.first};
    for (const auto& [along, vertex] : between) chain.push_back(vertex);
    chain.push_back(edge.second);
    return chain;
  }

  ClosedAtTJunctions result_;
};

}  // namespace

std::optional<ClosedAtTJunctions> closedAtTJunctions(const TriangleMesh& mesh) { return TJunctions(mesh).close(); }

}  // namespace glissade
