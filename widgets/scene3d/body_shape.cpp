#include "widgets/scene3d/body_shape.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

/// Faces that meet at less than this angle are one smooth surface: 30 degrees.
const double kFeatureCosine = std::cos(std::acos(-1.0) / 6.0);
/// A corner of more triangles keeps the normal of its face: comparing all pairs would take too long.
constexpr std::size_t kMostTrianglesAtCorner = 64;

struct EdgeOfTriangle {
  std::uint32_t first;
  std::uint32_t second;
  std::uint32_t triangle;
};

std::vector<EdgeOfTriangle> sortedEdges(const TriangleMesh& mesh) {
  std::vector<EdgeOfTriangle> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const TriangleIndices& triangle = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [first, second] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
      edges.push_back({first, second, t});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const EdgeOfTriangle& a, const EdgeOfTriangle& b) {
    return std::tie(a.first, a.second, a.triangle) < std::tie(b.first, b.second, b.triangle);
  });
  return edges;
}

/// The edges that a drawing shows: open ones, and those whose faces meet at more than the feature angle.
osg::ref_ptr<osg::Vec3Array> featureEdges(const TriangleMesh& mesh, const std::vector<Vector3>& normals) {
  osg::ref_ptr<osg::Vec3Array> ends = new osg::Vec3Array;
  const std::vector<EdgeOfTriangle> edges = sortedEdges(mesh);
  for (auto begin = edges.begin(); begin != edges.end();) {
    const auto end = std::find_if(begin, edges.end(), [&](const EdgeOfTriangle& edge) {
      return edge.first != begin->first || edge.second != begin->second;
    });
    const bool smooth =
        end - begin == 2 && normals[begin->triangle].dot(normals[(begin + 1)->triangle]) > kFeatureCosine;
    if (!smooth) {
      ends->push_back(toOsg(mesh.vertices[begin->first]));
      ends->push_back(toOsg(mesh.vertices[begin->second]));
    }
    begin = end;
  }
  return ends;
}

/// The triangles at each vertex: those of vertex v are triangles[begin[v]] to triangles[begin[v + 1] - 1].
struct TrianglesAtVertices {
  std::vector<std::size_t> begin;
  std::vector<std::uint32_t> triangles;
};

TrianglesAtVertices trianglesAtVertices(const TriangleMesh& mesh) {
  TrianglesAtVertices at;
  at.begin.assign(mesh.vertices.size() + 1, 0);
  for (const TriangleIndices& triangle : mesh.triangles) {
    for (const auto vertex : triangle) ++at.begin[vertex + 1];
  }
  std::partial_sum(at.begin.begin(), at.begin.end(), at.begin.begin());
  at.triangles.resize(at.begin.back());
  std::vector<std::size_t> next(at.begin.begin(), at.begin.end() - 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const auto vertex : mesh.triangles[t]) at.triangles[next[vertex]++] = t;
  }
  return at;
}

double angleAt(const TriangleMesh& mesh, const TriangleIndices& triangle, std::uint32_t vertex) {
  const std::size_t corner = triangle[0] == vertex ? 0 : triangle[1] == vertex ? 1 : 2;
  const Vector3& p = mesh.vertices[vertex];
  const Vector3 a = mesh.vertices[triangle[(corner + 1) % 3]] - p;
  const Vector3 b = mesh.vertices[triangle[(corner + 2) % 3]] - p;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The mean normal, weighted by angles, of the triangles at a vertex that continue the surface of one of them.
Vector3 cornerNormal(const TriangleMesh& mesh, const std::vector<Vector3>& normals, const TrianglesAtVertices& at,
                     std::uint32_t triangle, std::uint32_t vertex) {
  const std::size_t begin = at.begin[vertex];
  const std::size_t end = at.begin[vertex + 1];
  if (end - begin > kMostTrianglesAtCorner) return normals[triangle];
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint32_t other = at.triangles[i];
    if (normals[other].dot(normals[triangle]) <= kFeatureCosine) continue;
    sum += angleAt(mesh, mesh.triangles[other], vertex) * normals[other];
  }
  const double length = sum.norm();
  return length > 0.0 ? Vector3(sum / length) : normals[triangle];
}

}  // namespace

BodyShape makeBodyShape(const TriangleMesh& input) {
  const TriangleMesh mesh = welded(input);
  std::vector<Vector3> normals;
  normals.reserve(mesh.triangles.size());
  for (const TriangleIndices& triangle : mesh.triangles) normals.push_back(faceNormal(mesh, triangle));
  const TrianglesAtVertices at = trianglesAtVertices(mesh);
  BodyShape shape{new osg::Vec3Array, new osg::Vec3Array, featureEdges(mesh, normals)};
  shape.corners->reserve(3 * mesh.triangles.size());
  shape.normals->reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const auto vertex : mesh.triangles[t]) {
      shape.corners->push_back(toOsg(mesh.vertices[vertex]));
      shape.normals->push_back(toOsg(cornerNormal(mesh, normals, at, t, vertex)));
    }
  }
  return shape;
}

const BodyShape& BodyShapes::of(const MeshPtr& mesh) {
  const auto [entry, isNew] = shapes_.try_emplace(mesh.get());
  if (isNew || entry->second.mesh.expired()) entry->second = {mesh, makeBodyShape(*mesh)};
  return entry->second.shape;
}

void BodyShapes::dropUnused() {
  for (auto entry = shapes_.begin(); entry != shapes_.end();) {
    entry = entry->second.mesh.expired() ? shapes_.erase(entry) : std::next(entry);
  }
}

}  // namespace glissade
