#include "engine/geometry/mesh_audit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

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

/// An edge between two vertices as a triangle uses it.
struct EdgeUse {
  std::pair<std::uint32_t, std::uint32_t> edge;  ///< the lower vertex first
  bool forward = false;                          ///< from the lower to the higher
};

/// Uses of the same edge are neighbours.
std::vector<EdgeUse> edgeUses(const TriangleMesh& mesh) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangle[i];
      const std::uint32_t to = triangle[(i + 1) % 3];
      uses.push_back({std::minmax(from, to), from < to});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) { return a.edge < b.edge; });
  return uses;
}

void auditEdges(const TriangleMesh& mesh, MeshAudit& result) {
  const std::vector<EdgeUse> uses = edgeUses(mesh);
  for (auto first = uses.begin(); first != uses.end();) {
    const auto other = [&](const EdgeUse& use) { return use.edge != first->edge; };
    const auto last = std::find_if(first, uses.end(), other);
    const auto forward = std::count_if(first, last, [](const EdgeUse& use) { return use.forward; });
    if ((last - first) % 2 != 0) ++result.openEdges;
    if (2 * forward != last - first) result.consistentlyOriented = false;
    first = last;
  }
}

std::size_t componentCount(const TriangleMesh& mesh) {
  Components components = connectedVertices(mesh);
  std::vector<bool> counted(mesh.vertices.size(), false);
  std::size_t count = 0;
  for (const TriangleIndices& triangle : mesh.triangles) {
    const std::uint32_t component = components.find(triangle[0]);
    if (!counted[component]) ++count;
    counted[component] = true;
  }
  return count;
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
  result.components = componentCount(mesh);
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

std::vector<TriangleMesh> connectedComponents(const TriangleMesh& input) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  const TriangleMesh mesh = welded(input);
  Components components = connectedVertices(mesh);
  std::vector<std::uint32_t> partOf(mesh.vertices.size(), kNone);  // by the vertex that stands for it
  std::vector<std::uint32_t> placeOf(mesh.vertices.size(), kNone);
  std::vector<TriangleMesh> parts;
  for (const TriangleIndices& triangle : mesh.triangles) {
    std::uint32_t& part = partOf[components.find(triangle[0])];
    if (part == kNone) {
      part = static_cast<std::uint32_t>(parts.size());
      parts.emplace_back();
    }
    TriangleMesh& target = parts[part];
    TriangleIndices moved;
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& place = placeOf[triangle[i]];
      if (place == kNone) {
        place = static_cast<std::uint32_t>(target.vertices.size());
        target.vertices.push_back(mesh.vertices[triangle[i]]);
      }
      moved[i] = place;
    }
    target.triangles.push_back(moved);
  }
  return parts;
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
