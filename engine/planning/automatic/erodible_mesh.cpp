#include "engine/planning/automatic/erodible_mesh.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "engine/geometry/triangle_tree.h"

namespace glissade {
namespace {

/// Longest move of a vertex at a sharp edge, in depths.
constexpr double kLongestMove = 3.0;
/// Largest share of the body's thickness that erosion removes from one side.
constexpr double kThicknessShare = 0.4;
/// In radii. Nearer hits of a ray inwards belong to the face at which the ray begins.
constexpr double kSameSurface = 1e-6;
/// Smaller eigenvalues of the normals' matrix belong to directions in which the vertex need not move.
constexpr double kFlat = 1e-3;

/// The shortest move that takes a vertex by `depths` along each of its normals.
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

ErodibleMesh::ErodibleMesh(const TriangleMesh& mesh) : mesh_(welded(mesh)) {
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c] : mesh_.triangles) {
    triangles.push_back({mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]});
  }
  const TriangleTree surface(triangles);
  const double beyond = kSameSurface * radiusAboutOrigin(mesh_);
  for (const Triangle& triangle : triangles) {
    const Vector3 across = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    const Vector3 normal = across.stableNormalized();
    const Vector3 middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
    faces_.push_back({normal, across.norm(), kThicknessShare * surface.firstHit(middle, -normal, beyond)});
  }
}

TriangleMesh ErodibleMesh::eroded(double depth) const {
  TriangleMesh result = mesh_;
  std::vector<Eigen::Matrix3d> normals(result.vertices.size(), Eigen::Matrix3d::Zero());
  std::vector<Vector3> moments(result.vertices.size(), Vector3::Zero());
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Face& face = faces_[f];
    for (const std::uint32_t vertex : result.triangles[f]) {
      normals[vertex] += face.area * face.normal * face.normal.transpose();
      moments[vertex] -= face.area * std::min(depth, face.room) * face.normal;
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
