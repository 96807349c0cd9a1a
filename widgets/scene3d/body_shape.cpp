#include "widgets/scene3d/body_shape.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "engine/base/in_threads.h"
#include "engine/base/reserve_filled.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

/// Faces that meet at less than this angle are one smooth surface: 30 degrees.
const double kFeatureCosine = std::cos(std::acos(-1.0) / 6.0);
/// A corner with more triangles keeps the normal of its face, because comparing all pairs would take too long.
constexpr std::size_t kMostTrianglesAtCorner = 64;
/// Triangles that a thread takes at a time.
constexpr std::size_t kAtOnce = 1U << 16;

/// The corners of triangles at each vertex: those of vertex v are corners[begin[v]] to corners[begin[v + 1] - 1].
/// Corner i of triangle t has the number 3 t + i. They are in the order of the triangles.
struct CornersAtVertices {
  std::vector<std::size_t> begin;
  std::vector<std::uint32_t> corners;
};

CornersAtVertices cornersAtVertices(const TriangleMesh& mesh) {
  CornersAtVertices at;
  at.begin.assign(mesh.vertices.size() + 1, 0);
  for (const TriangleIndices& triangle : mesh.triangles) {
    for (const auto vertex : triangle) ++at.begin[vertex + 1];
  }
  std::partial_sum(at.begin.begin(), at.begin.end(), at.begin.begin());
  reserveFilled(at.corners, at.begin.back());
  at.corners.resize(at.begin.back());
  std::vector<std::size_t> next(at.begin.begin(), at.begin.end() - 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) at.corners[next[mesh.triangles[t][i]]++] = 3 * t + i;
  }
  return at;
}

/// The edges that a drawing shows: open ones, and those whose faces meet at more than the feature angle.
osg::ref_ptr<osg::Vec3Array> featureEdges(const TriangleMesh& mesh, const std::vector<Vector3>& normals,
                                          const CornersAtVertices& at) {
  struct EdgeUse {
    std::uint32_t higher;  ///< the other vertex
    std::uint32_t triangle;
  };
  osg::ref_ptr<osg::Vec3Array> ends = new osg::Vec3Array;
  std::vector<EdgeUse> uses;  // uses of the edges from a vertex to higher ones
  for (std::uint32_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    uses.clear();
    for (std::size_t i = at.begin[vertex]; i < at.begin[vertex + 1]; ++i) {
      const std::uint32_t triangle = at.corners[i] / 3;
      for (const auto other : mesh.triangles[triangle]) {
        if (other > vertex) uses.push_back({other, triangle});
      }
    }
    std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
      return std::tie(a.higher, a.triangle) < std::tie(b.higher, b.triangle);
    });
    for (auto begin = uses.begin(); begin != uses.end();) {
      const auto end = std::find_if(begin, uses.end(), [&](const EdgeUse& use) { return use.higher != begin->higher; });
      const bool smooth =
          end - begin == 2 && normals[begin->triangle].dot(normals[(begin + 1)->triangle]) > kFeatureCosine;
      if (!smooth) {
        ends->push_back(toOsg(mesh.vertices[vertex]));
        ends->push_back(toOsg(mesh.vertices[begin->higher]));
      }
      begin = end;
    }
  }
  return ends;
}

std::vector<Vector3> faceNormals(const TriangleMesh& mesh) {
  std::vector<Vector3> normals;
  reserveFilled(normals, mesh.triangles.size());
  normals.resize(mesh.triangles.size());
  forEachInThreads(normals.size(), kAtOnce, [&](std::size_t t) { normals[t] = faceNormal(mesh, mesh.triangles[t]); });
  return normals;
}

/// The angle of each corner, by the corner's number.
std::vector<double> cornerAngles(const TriangleMesh& mesh) {
  std::vector<double> angles;
  reserveFilled(angles, 3 * mesh.triangles.size());
  angles.resize(3 * mesh.triangles.size());
  forEachInThreads(mesh.triangles.size(), kAtOnce, [&](std::size_t t) {
    const TriangleIndices& triangle = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3& p = mesh.vertices[triangle[i]];
      const Vector3 a = mesh.vertices[triangle[(i + 1) % 3]] - p;
      const Vector3 b = mesh.vertices[triangle[(i + 2) % 3]] - p;
      angles[3 * t + i] = std::atan2(a.cross(b).norm(), a.dot(b));
    }
  });
  return angles;
}

/// The mean normal, weighted by angles, of the triangles at a vertex that continue the surface of one of them.
Vector3 cornerNormal(const std::vector<Vector3>& normals, const std::vector<double>& angles,
                     const CornersAtVertices& at, std::uint32_t triangle, std::uint32_t vertex) {
  const std::size_t begin = at.begin[vertex];
  const std::size_t end = at.begin[vertex + 1];
  if (end - begin > kMostTrianglesAtCorner) return normals[triangle];
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = begin; i < end; ++i) {
    const Vector3& other = normals[at.corners[i] / 3];
    if (other.dot(normals[triangle]) <= kFeatureCosine) continue;
    sum += angles[at.corners[i]] * other;
  }
  const double length = sum.norm();
  return length > 0.0 ? Vector3(sum / length) : normals[triangle];
}

}  // namespace

BodyShape makeBodyShape(const TriangleMesh& input) {
  const TriangleMesh mesh = welded(input);
  const std::vector<Vector3> normals = faceNormals(mesh);
  const CornersAtVertices at = cornersAtVertices(mesh);
  const std::vector<double> angles = cornerAngles(mesh);
  BodyShape shape;
  shape.corners = new osg::Vec3Array;
  shape.normals = new osg::Vec3Array;
  shape.edges = featureEdges(mesh, normals, at);
  for (osg::Vec3Array* array : {shape.corners.get(), shape.normals.get()}) {
    reserveFilled(array->asVector(), 3 * mesh.triangles.size());
    array->resize(3 * mesh.triangles.size());
  }
  forEachInThreads(mesh.triangles.size(), kAtOnce, [&](std::size_t t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t vertex = mesh.triangles[t][i];
      (*shape.corners)[3 * t + i] = toOsg(mesh.vertices[vertex]);
      (*shape.normals)[3 * t + i] = toOsg(cornerNormal(normals, angles, at, static_cast<std::uint32_t>(t), vertex));
    }
  });
  shape.edgeDensity = edgeDensity(shape);
  return shape;
}

const BodyShape& BodyShapes::of(const MeshPtr& mesh) {
  const auto [entry, isNew] = shapes_.try_emplace(mesh.get());
  if (isNew || entry->second.mesh.expired()) {
    entry->second = {mesh, makeBodyShape(*mesh)};
    entry->second.shape.coarser = std::make_shared<LateDetails>(entry->second.shape, worker_);
  }
  return entry->second.shape;
}

void BodyShapes::dropUnused() {
  for (auto entry = shapes_.begin(); entry != shapes_.end();) {
    entry = entry->second.mesh.expired() ? shapes_.erase(entry) : std::next(entry);
  }
}

}  // namespace glissade
