#include "engine/geometry/primitives.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace glissade {
namespace {

std::uint32_t midpoint(TriangleMesh& mesh, std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>& known,
                       std::uint32_t a, std::uint32_t b) {
  const auto [entry, inserted] = known.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
  if (inserted) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
  return entry->second;
}

TriangleMesh icosahedron() {
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  TriangleMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vector3& vertex : mesh.vertices) vertex.normalize();
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return mesh;
}

TriangleMesh subdivided(const TriangleMesh& mesh) {
  TriangleMesh finer;
  finer.vertices = mesh.vertices;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto ab = midpoint(finer, known, a, b);
    const auto bc = midpoint(finer, known, b, c);
    const auto ca = midpoint(finer, known, c, a);
    finer.triangles.insert(finer.triangles.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return finer;
}

/// Distance from the origin to the nearest face plane of a convex mesh around the origin.
double inradius(const TriangleMesh& mesh) {
  double smallest = radiusAboutOrigin(mesh);
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3 normal = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
    smallest = std::min(smallest, std::abs(normal.normalized().dot(mesh.vertices[a])));
  }
  return smallest;
}

}  // namespace

TriangleMesh makeBox(const Vector3& size) {
  const Vector3 h = size / 2.0;
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.vertices.emplace_back((corner & 1) ? h.x() : -h.x(), (corner & 2) ? h.y() : -h.y(),
                               (corner & 4) ? h.z() : -h.z());
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TriangleMesh makeCylinder(double radius, double length, int segments) {
  const double outer = radius / std::cos(std::numbers::pi / segments);
  TriangleMesh mesh;
  mesh.vertices.emplace_back(0, 0, -length / 2);
  mesh.vertices.emplace_back(0, 0, length / 2);
  for (int i = 0; i < segments; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / segments;
    mesh.vertices.emplace_back(outer * std::cos(angle), outer * std::sin(angle), -length / 2);
    mesh.vertices.emplace_back(outer * std::cos(angle), outer * std::sin(angle), length / 2);
  }
  for (int i = 0; i < segments; ++i) {
    const auto low = static_cast<std::uint32_t>(2 + 2 * i);
    const auto nextLow = static_cast<std::uint32_t>(2 + 2 * ((i + 1) % segments));
    mesh.triangles.insert(
        mesh.triangles.end(),
        {{0, nextLow, low}, {1, low + 1, nextLow + 1}, {low, nextLow, low + 1}, {nextLow, nextLow + 1, low + 1}});
  }
  return mesh;
}

TriangleMesh makeSphere(double radius, int subdivisions) {
  TriangleMesh mesh = icosahedron();
  for (int i = 0; i < subdivisions; ++i) mesh = subdivided(mesh);
  const double outer = radius / inradius(mesh);
  return scaled(mesh, Vector3::Constant(outer));
}

}  // namespace glissade
