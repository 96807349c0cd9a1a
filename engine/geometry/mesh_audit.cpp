#include "engine/geometry/mesh_audit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace glissade {
namespace {

/// Union-find over vertex indices with path halving.
class Components {
 public:
  explicit Components(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t find(std::uint32_t item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }
  void unite(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::uint32_t> parent_;
};

Components connectedVertices(const TriangleMesh& mesh) {
  Components components(mesh.vertices.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    components.unite(a, b);
    components.unite(b, c);
  }
  return components;
}

/// An edge as a triangle uses it, seen from its lower vertex.
struct EdgeUse {
  std::uint32_t higher = 0;  ///< the other vertex
  bool forward = false;      ///< from the lower to the higher
};

/// The uses of all edges, by their lower vertex.
struct EdgeUses {
  std::vector<EdgeUse> uses;
  std::vector<std::size_t> begins;  ///< of each vertex; one more at the end

  explicit EdgeUses(const TriangleMesh& mesh) : uses(3 * mesh.triangles.size()), begins(mesh.vertices.size() + 1, 0) {
    visit(mesh, [&](std::uint32_t lower, const EdgeUse&) { ++begins[lower + 1]; });
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    std::vector<std::size_t> next = begins;
    visit(mesh, [&](std::uint32_t lower, const EdgeUse& use) { uses[next[lower]++] = use; });
  }

 private:
  template <class Take>
  static void visit(const TriangleMesh& mesh, const Take& take) {
    for (const auto& triangle : mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = triangle[i];
        const std::uint32_t to = triangle[(i + 1) % 3];
        take(std::min(from, to), {std::max(from, to), from < to});
      }
    }
  }
};

void auditEdges(const TriangleMesh& mesh, MeshAudit& result) {
  EdgeUses edges(mesh);
  for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    const auto end = edges.uses.begin() + static_cast<std::ptrdiff_t>(edges.begins[vertex + 1]);
    auto first = edges.uses.begin() + static_cast<std::ptrdiff_t>(edges.begins[vertex]);
    std::sort(first, end, [](const EdgeUse& a, const EdgeUse& b) { return a.higher < b.higher; });
    while (first != end) {
      const auto last = std::find_if(first, end, [&](const EdgeUse& use) { return use.higher != first->higher; });
      const auto forward = std::count_if(first, last, [](const EdgeUse& use) { return use.forward; });
      if ((last - first) % 2 != 0) ++result.openEdges;
      if (2 * forward != last - first) result.consistentlyOriented = false;
      first = last;
    }
  }
}

std::vector<ConnectedSurface> connectedSurfaces(const TriangleMesh& mesh) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  Components components = connectedVertices(mesh);
  std::vector<std::uint32_t> surfaceOf(mesh.vertices.size(), kNone);  // by the vertex that stands for it
  std::vector<ConnectedSurface> surfaces;
  for (const TriangleIndices& triangle : mesh.triangles) {
    std::uint32_t& surface = surfaceOf[components.find(triangle[0])];
    if (surface == kNone) {
      surface = static_cast<std::uint32_t>(surfaces.size());
      surfaces.push_back({mesh.vertices[triangle[0]], Box3()});
    }
    for (const std::uint32_t corner : triangle) surfaces[surface].box.extend(mesh.vertices[corner]);
  }
  return surfaces;
}

double solidAngle(const Vector3& a, const Vector3& b, const Vector3& c) {
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  const double numerator = a.dot(b.cross(c));
  const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return 2.0 * std::atan2(numerator, denominator);
}

}  // namespace

MeshAudit audit(const TriangleMesh& input) {
  const TriangleMesh mesh = welded(input);
  MeshAudit result;
  result.triangles = input.triangles.size();
  result.degenerateTriangles = input.triangles.size() - mesh.triangles.size();
  result.surfaces = connectedSurfaces(mesh);
  result.box = boundingBox(input);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3& pa = mesh.vertices[a];
    const Vector3& pb = mesh.vertices[b];
    const Vector3& pc = mesh.vertices[c];
    if ((pb - pa).cross(pc - pa).norm() == 0.0) ++result.degenerateTriangles;
    result.volume += pa.dot(pb.cross(pc)) / 6.0;
  }
  auditEdges(mesh, result);
  return result;
}

double windingNumber(const TriangleMesh& mesh, const Vector3& p) {
  double total = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    total += solidAngle(mesh.vertices[a] - p, mesh.vertices[b] - p, mesh.vertices[c] - p);
  }
  return total / (4.0 * std::numbers::pi);
}

bool containsPoint(const TriangleMesh& closedMesh, const Vector3& p) {
  return std::abs(windingNumber(closedMesh, p)) > 0.5;
}

}  // namespace glissade
