#include "engine/fits/cylinder_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/geometry/circle_fit.h"

namespace glissade {
namespace {

/// Ratio of the second to the largest eigenvalue of the normals' matrix below which the facets are one plane.
constexpr double kTurning = 1e-3;
/// Share of the radius by which a first estimate may deviate before it is refined.
constexpr double kRoughly = 0.1;
constexpr int kRefinements = 8;

/// The direction to which the normals are perpendicular.
std::optional<Vector3> axisOf(const std::vector<Vector3>& normals) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Vector3& normal : normals) sum += normal * normal.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
  if (solver.eigenvalues()[1] < kTurning * solver.eigenvalues()[2]) return std::nullopt;
  return Vector3(solver.eigenvectors().col(0));
}

double largestError(const FittedCylinder& cylinder, const std::vector<Vector3>& points) {
  double largest = 0.0;
  for (const Vector3& p : points) {
    largest = std::max(largest, std::abs(cylinder.distanceFromAxis(p) - cylinder.radius));
  }
  return largest;
}

/// One Gauss-Newton step on the distances from the surface, over position, direction and radius.
void refine(FittedCylinder& cylinder, const std::vector<Vector3>& points) {
  using Vector5 = Eigen::Matrix<double, 5, 1>;
  const Vector3 u = cylinder.direction.unitOrthogonal();
  const Vector3 v = cylinder.direction.cross(u);
  Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
  Vector5 right = Vector5::Zero();
  for (const Vector3& p : points) {
    const Vector3 from = p - cylinder.point;
    const double height = from.dot(cylinder.direction) / cylinder.radius;
    const Vector3 across = from - from.dot(cylinder.direction) * cylinder.direction;
    const double distance = across.norm();
    if (distance <= 0.0) continue;
    const Vector3 radial = across / distance;
    Vector5 row;
    row << -radial.dot(u), -radial.dot(v), -height * radial.dot(u), -height * radial.dot(v), -1.0;
    normal += row * row.transpose();
    right += row * (cylinder.radius - distance);
  }
  // If all points are at one height, the singular direction of the sum stays fixed.
  normal.diagonal().array() += 1e-12 * normal.trace();
  const Vector5 step = normal.ldlt().solve(right);
  if (!step.allFinite()) return;
  cylinder.point += step[0] * u + step[1] * v;
  cylinder.direction = (cylinder.direction + (step[2] * u + step[3] * v) / cylinder.radius).normalized();
  cylinder.radius += step[4];
}

}  // namespace

std::optional<FittedCylinder> fitCylinder(const std::vector<Vector3>& points, const std::vector<Vector3>& normals,
                                          double tolerance) {
  const auto axis = axisOf(normals);
  if (!axis || points.size() < 5) return std::nullopt;
  const auto circle = fitCircle(points, *axis);
  if (!circle) return std::nullopt;
  FittedCylinder cylinder{circle->middle, *axis, circle->radius};
  if (largestError(cylinder, points) > std::max(tolerance, kRoughly * cylinder.radius)) return std::nullopt;
  for (int i = 0; i < kRefinements && largestError(cylinder, points) > 0.01 * tolerance; ++i) {
    refine(cylinder, points);
    if (!(cylinder.radius > 0.0)) return std::nullopt;
  }
  return largestError(cylinder, points) <= tolerance ? std::optional(cylinder) : std::nullopt;
}

}  // namespace glissade
