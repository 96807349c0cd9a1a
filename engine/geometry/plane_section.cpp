#include "engine/geometry/plane_section.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace glissade {
namespace {

/// Share of the mesh's size within which a vertex counts as on the plane. Coordinates are rounded, in files to single
/// precision, so that a face in the plane would else be cut in some of its triangles and not in others.
constexpr double kOnPlane = 1e-6;

using Edge = std::pair<std::uint32_t, std::uint32_t>;

Edge edgeBetween(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

/// A crossed triangle: the section enters it through one edge and leaves it through the other, with the solid on the
/// left, seen against the normal.
struct Crossing {
  Edge from;
  Edge to;
};

/// The crossing of a triangle whose corner a is alone on its side of the plane: edges a-b and c-a are crossed.
Crossing crossingOf(const TriangleIndices& triangle, std::size_t alone, bool aloneIsAbove) {
  const std::uint32_t a = triangle[alone];
  const Edge first = edgeBetween(a, triangle[(alone + 1) % 3]);
  const Edge second = edgeBetween(a, triangle[(alone + 2) % 3]);
  return aloneIsAbove ? Crossing{first, second} : Crossing{second, first};
}

class Section {
 public:
  Section(const TriangleMesh& mesh, const Plane& plane) : mesh_(mesh) {
    heights_.reserve(mesh.vertices.size());
    const double slack = mesh.vertices.empty() ? 0.0 : kOnPlane * boundingBox(mesh).diagonal().norm();
    for (const Vector3& vertex : mesh.vertices) {
      const double height = plane.normal.dot(vertex) - plane.offset;
      heights_.push_back(std::abs(height) <= slack ? 0.0 : height);
    }
  }

  std::vector<std::vector<Vector3>> polygons() const {
    std::multimap<Edge, Edge> next;
    for (const TriangleIndices& triangle : mesh_.triangles) addCrossing(triangle, next);
    std::vector<std::vector<Vector3>> polygons;
    while (!next.empty()) {
      std::vector<Vector3> polygon = takePolygon(next);
      if (polygon.size() > 2) polygons.push_back(std::move(polygon));
    }
    return polygons;
  }

 private:
  bool isAbove(std::uint32_t vertex) const { return heights_[vertex] >= 0.0; }

  void addCrossing(const TriangleIndices& triangle, std::multimap<Edge, Edge>& next) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const bool above = isAbove(triangle[i]);
      if (isAbove(triangle[(i + 1) % 3]) == above || isAbove(triangle[(i + 2) % 3]) == above) continue;
      const Crossing crossing = crossingOf(triangle, i, above);
      next.emplace(crossing.from, crossing.to);
      return;
    }
  }

  /// Follows crossings from the first one until they come back to it; empty where they end elsewhere.
  std::vector<Vector3> takePolygon(std::multimap<Edge, Edge>& next) const {
    const Edge start = next.begin()->first;
    std::vector<Vector3> polygon;
    Edge edge = start;
    do {
      const auto crossing = next.find(edge);
      if (crossing == next.end()) return {};
      polygon.push_back(pointOn(edge));
      edge = crossing->second;
      next.erase(crossing);
    } while (edge != start);
    return polygon;
  }

  Vector3 pointOn(const Edge& edge) const {
    const double below = heights_[edge.first];
    const double above = heights_[edge.second];
    const double at = below / (below - above);
    return mesh_.vertices[edge.first] + at * (mesh_.vertices[edge.second] - mesh_.vertices[edge.first]);
  }

  const TriangleMesh& mesh_;
  std::vector<double> heights_;
};

}  // namespace

Plane planeInBody(const Plane& plane_W, const Pose& X_WB) {
  return {inverse(X_WB).orientation * plane_W.normal, plane_W.offset - plane_W.normal.dot(X_WB.position)};
}

std::vector<std::vector<Vector3>> planeSection(const TriangleMesh& mesh, const Plane& plane) {
  return Section(mesh, plane).polygons();
}

}  // namespace glissade
