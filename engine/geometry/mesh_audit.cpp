#include "engine/geometry/mesh_audit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/geometry/joined_sets.h"
#include "engine/geometry/mesh_edges.h"

namespace glissade {
namespace {

JoinedSets connectedVertices(const TriangleMesh& mesh) {
  JoinedSets components(mesh.vertices.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    components.join(a, b);
    components.join(b, c);
  }
  return components;
}

std::vector<ConnectedSurface> connectedSurfaces(const TriangleMesh& mesh) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  JoinedSets components = connectedVertices(mesh);
  std::vector<std::uint32_t> surfaceOf(mesh.vertices.size(), kNone);  // surface by its representative vertex
  std::vector<ConnectedSurface> surfaces;
  for (const TriangleIndices& triangle : mesh.triangles) {
    std::uint32_t& surface = surfaceOf[components.of(triangle[0])];
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
  const EdgeFacts edges = edgeFactsOf(mesh);
  result.openEdges = edges.open;
  result.consistentlyOriented = edges.consistentlyOriented;
  return result;
}

bool isClosedSurface(const TriangleMesh& mesh) {
  if (mesh.empty()) return false;
  // If every edge has an even number of triangles, it still has one after vertices are merged.
  return edgeFactsOf(mesh).open == 0 || edgeFactsOf(welded(mesh)).open == 0;
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
