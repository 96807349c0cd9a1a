#include "engine/geometry/convex_distance.h"

#include <Eigen/LU>
#include <limits>
#include <optional>
#include <vector>

namespace glissade {
namespace {

/// Most iterations. More are needed only where rounding prevents progress.
constexpr int kMostIterations = 100;

/// The vertex of the placed mesh that is farthest in a direction of the world.
Vector3 farthest(const TriangleMesh& mesh, const Pose& X_WM, const Vector3& direction_W) {
  const Vector3 direction = X_WM.orientation.conjugate() * direction_W;
  const Vector3* best = &mesh.vertices.front();
  double most = -std::numeric_limits<double>::infinity();
  for (const Vector3& vertex : mesh.vertices) {
    const double along = vertex.dot(direction);
    if (along <= most) continue;
    most = along;
    best = &vertex;
  }
  return X_WM * *best;
}

/// The point nearest to the origin on the plane, line or point through some corners; nothing where it is not between
/// them.
std::optional<Vector3> nearestBetween(const std::vector<Vector3>& corners) {
  const auto count = static_cast<Eigen::Index>(corners.size()) - 1;
  if (count == 0) return corners.front();
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> sides(3, count);
  for (Eigen::Index i = 0; i < count; ++i) sides.col(i) = corners[static_cast<std::size_t>(i) + 1] - corners.front();
  const auto gram = (sides.transpose() * sides).eval();
  const Eigen::FullPivLU<std::decay_t<decltype(gram)>> solver(gram);
  if (!solver.isInvertible()) return std::nullopt;
  const auto shares = solver.solve(-sides.transpose() * corners.front()).eval();
  if ((shares.array() < 0.0).any() || shares.sum() > 1.0) return std::nullopt;
  return corners.front() + sides * shares;
}

/// The point of the simplex that is nearest to the origin. Removes the corners that do not support it.
Vector3 nearestOf(std::vector<Vector3>& simplex) {
  std::vector<Vector3> best;
  Vector3 nearest = Vector3::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (unsigned chosen = 1; chosen < 1U << simplex.size(); ++chosen) {
    std::vector<Vector3> corners;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      if ((chosen >> i & 1U) != 0) corners.push_back(simplex[i]);
    }
    const auto point = corners.size() > 4 ? std::nullopt : nearestBetween(corners);
    if (!point || point->squaredNorm() >= least) continue;
    least = point->squaredNorm();
    nearest = *point;
    best = std::move(corners);
  }
  simplex = std::move(best);
  return nearest;
}

}  // namespace

bool hullsApart(const TriangleMesh& a, const Pose& X_WA, const TriangleMesh& b, const Pose& X_WB, double distance) {
  // The distance of the hulls is that of the hull of all differences of vertices from the origin.
  Vector3 nearest = X_WA * a.vertices.front() - X_WB * b.vertices.front();
  std::vector<Vector3> simplex{nearest};
  for (int i = 0; i < kMostIterations; ++i) {
    const double length = nearest.norm();
    if (length <= distance) return false;
    const Vector3 next = farthest(a, X_WA, -nearest) - farthest(b, X_WB, nearest);
    if (next.dot(nearest) > distance * length) return true;
    if (nearest.squaredNorm() - next.dot(nearest) <= 1e-12 * nearest.squaredNorm()) return false;
    simplex.push_back(next);
    nearest = nearestOf(simplex);
  }
  return false;
}

}  // namespace glissade
