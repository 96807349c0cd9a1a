#include "engine/planning/automatic/eroded_mesh.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace glissade {
namespace {

/// A vertex of a sharp edge moves by at most this many depths.
constexpr double kLongestMove = 3.0;
/// From either side at most this share of the thickness goes.
constexpr double kThicknessShare = 0.4;
/// Smaller eigenvalues of the normals' matrix are directions in which the vertex need not move.
constexpr double kFlat = 1e-3;

struct Face {
  Vector3 a, b, c;
  Vector3 normal;  ///< outwards
  Vector3 centre() const { return (a + b + c) / 3.0; }
};

std::vector<Face> facesOf(const TriangleMesh& mesh) {
  std::vector<Face> faces;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vector3& a = mesh.vertices[i];
    const Vector3& b = mesh.vertices[j];
    const Vector3& c = mesh.vertices[k];
    faces.push_back({a, b, c, (b - a).cross(c - a).stableNormalized()});
  }
  return faces;
}

/// Where a ray hits a face (T. Moller, B. Trumbore 1997), in units of its direction.
std::optional<double> hit(const Vector3& origin, const Vector3& direction, const Face& face) {
  const Vector3 e1 = face.b - face.a;
  const Vector3 e2 = face.c - face.a;
  const Vector3 p = direction.cross(e2);
  const double determinant = e1.dot(p);
  if (determinant == 0.0) return std::nullopt;
  const Vector3 s = origin - face.a;
  const double u = s.dot(p) / determinant;
  const Vector3 q = s.cross(e1);
  const double v = direction.dot(q) / determinant;
  if (u < 0.0 || v < 0.0 || u + v > 1.0) return std::nullopt;
  return e2.dot(q) / determinant;
}

/// How thick the body is below the middle of a face.
double thicknessBelow(const Face& face, const std::vector<Face>& faces, double scale) {
  double least = std::numeric_limits<double>::infinity();
  for (const Face& other : faces) {
    const auto t = hit(face.centre(), -face.normal, other);
    if (t && *t > 1e-6 * scale) least = std::min(least, *t);
  }
  return least;
}

/// The least move that takes a vertex by `depths` along each of its normals.
Vector3 moveOf(const Eigen::Matrix3d& normals, const Vector3& moments) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normals);
  Vector3 move = Vector3::Zero();
  for (int i = 0; i < 3; ++i) {
    const double value = solver.eigenvalues()[i];
    if (value < kFlat * solver.eigenvalues()[2]) continue;
    const Vector3 axis = solver.eigenvectors().col(i);
    move += axis * (axis.dot(moments) / value);
  }
  return move;
}

}  // namespace

TriangleMesh eroded(const TriangleMesh& mesh, double depth) {
  TriangleMesh result = welded(mesh);
  const std::vector<Face> faces = facesOf(result);
  const double scale = radiusAboutOrigin(result);
  std::vector<Eigen::Matrix3d> normals(result.vertices.size(), Eigen::Matrix3d::Zero());
  std::vector<Vector3> moments(result.vertices.size(), Vector3::Zero());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const double room = depth > 0.0 ? kThicknessShare * thicknessBelow(faces[f], faces, scale) : 0.0;
    const double by = depth > 0.0 ? std::min(depth, room) : depth;
    const double area = (faces[f].b - faces[f].a).cross(faces[f].c - faces[f].a).norm();
    for (const std::uint32_t vertex : result.triangles[f]) {
      normals[vertex] += area * faces[f].normal * faces[f].normal.transpose();
      moments[vertex] -= area * by * faces[f].normal;
    }
  }
  for (std::size_t vertex = 0; vertex < result.vertices.size(); ++vertex) {
    if (normals[vertex].isZero(0.0)) continue;
    Vector3 move = moveOf(normals[vertex], moments[vertex]);
    const double longest = kLongestMove * std::abs(depth);
    if (move.norm() > longest) move *= longest / move.norm();
    result.vertices[vertex] += move;
  }
  return result;
}

}  // namespace glissade
