#include "engine/planning/automatic/erodible_mesh.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/geometry/triangle_pair.h"

namespace glissade {
namespace {

/// A vertex of a sharp edge moves by at most this many depths.
constexpr double kLongestMove = 3.0;
/// From either side at most this share of the thickness goes.
constexpr double kThicknessShare = 0.4;
/// Smaller eigenvalues of the normals' matrix are directions in which the vertex need not move.
constexpr double kFlat = 1e-3;

/// A triangle that a ray may hit, in a sphere about its middle.
struct Target {
  Vector3 corner, e1, e2;
  Vector3 middle;
  double squaredRadius;

  explicit Target(const Triangle& t)
      : corner(t[0]), e1(t[1] - t[0]), e2(t[2] - t[0]), middle((t[0] + t[1] + t[2]) / 3.0) {
    squaredRadius =
        std::max({(t[0] - middle).squaredNorm(), (t[1] - middle).squaredNorm(), (t[2] - middle).squaredNorm()});
  }
};

/// Where the ray hits, in units of its direction (T. Moller, B. Trumbore 1997).
std::optional<double> hit(const Vector3& origin, const Vector3& direction, const Target& target) {
  const Vector3 p = direction.cross(target.e2);
  const double determinant = target.e1.dot(p);
  if (determinant == 0.0) return std::nullopt;
  const Vector3 s = origin - target.corner;
  const double u = s.dot(p) / determinant;
  const Vector3 q = s.cross(target.e1);
  const double v = direction.dot(q) / determinant;
  if (u < 0.0 || v < 0.0 || u + v > 1.0) return std::nullopt;
  return target.e2.dot(q) / determinant;
}

/// How thick the body is from `origin` inwards, along a unit vector.
double thickness(const Vector3& origin, const Vector3& inwards, const std::vector<Target>& targets, double scale) {
  constexpr double kRounding = 1.0 + 1e-9;
  double least = std::numeric_limits<double>::infinity();
  for (const Target& target : targets) {
    const Vector3 to = target.middle - origin;
    const double along = to.dot(inwards);
    if (to.squaredNorm() - along * along > kRounding * target.squaredRadius) continue;
    const auto t = hit(origin, inwards, target);
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

ErodibleMesh::ErodibleMesh(const TriangleMesh& mesh) : mesh_(welded(mesh)) {
  std::vector<Target> targets;
  for (const auto& [a, b, c] : mesh_.triangles) {
    targets.emplace_back(Triangle{mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]});
  }
  const double scale = radiusAboutOrigin(mesh_);
  for (const Target& target : targets) {
    const Vector3 across = target.e1.cross(target.e2);
    const Vector3 normal = across.stableNormalized();
    const double room = kThicknessShare * thickness(target.middle, -normal, targets, scale);
    faces_.push_back({normal, across.norm(), room});
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
