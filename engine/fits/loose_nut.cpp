#include "engine/fits/loose_nut.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/collision/collision_query.h"
#include "engine/geometry/thinned_mesh.h"

namespace glissade {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;
/// Largest distance of a nut's points from the axis, in radii of its thread.
constexpr double kCompact = 3.0;
/// A body is round if points near its largest radius leave no larger gap between their angles, radians.
constexpr double kRim = 0.97;
constexpr double kRoundGap = kFullTurn / 9.0;
/// Number of steps of a trial turn, and share of the radius by which the nut is thinned for it, so that mere contacts
/// do not hold it.
constexpr int kTurns = 24;
constexpr double kThinner = 0.02;

struct Polar {
  double radius;
  double angle;
};

std::vector<Polar> aboutAxis(const RigidBody& body, const ContactAxis& axis) {
  const Vector3 u = axis.direction.unitOrthogonal();
  const Vector3 v = axis.direction.cross(u);
  std::vector<Polar> points;
  for (const Vector3& vertex : body.mesh->vertices) {
    const Vector3 p = body.X_WB * vertex - axis.point;
    points.push_back({std::hypot(p.dot(u), p.dot(v)), std::atan2(p.dot(v), p.dot(u))});
  }
  return points;
}

double radiusOf(const std::vector<Polar>& points) {
  double radius = 0.0;
  for (const Polar& point : points) radius = std::max(radius, point.radius);
  return radius;
}

bool isRound(const std::vector<Polar>& points, double radius) {
  std::vector<double> angles;
  for (const Polar& point : points) {
    if (point.radius >= kRim * radius) angles.push_back(point.angle);
  }
  std::sort(angles.begin(), angles.end());
  double widest = angles.front() + kFullTurn - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) widest = std::max(widest, angles[i] - angles[i - 1]);
  return widest < kRoundGap;
}

MeshPtr thinner(const MeshPtr& mesh, double allowance) {
  const auto body = ThinnableMesh::of(*mesh);
  auto thinned = body ? body->thinned(allowance) : std::nullopt;
  return thinned ? std::make_shared<const TriangleMesh>(std::move(*thinned)) : mesh;
}

/// Bodies that the nut may meet when it turns.
std::vector<RigidBody> within(const std::vector<const RigidBody*>& others, const Vector3& middle, double radius) {
  const Vector3 reach = Vector3::Constant(radius);
  const Box3 box(middle - reach, middle + reach);
  std::vector<RigidBody> near;
  for (const RigidBody* other : others) {
    if (box.intersects(boundingBox(*other->mesh, other->X_WB))) near.push_back(*other);
  }
  return near;
}

}  // namespace

bool isLooseNut(const RigidBody& nut, const ContactAxis& axis, const std::vector<const RigidBody*>& others,
                const StopToken& stop) {
  const std::vector<Polar> points = aboutAxis(nut, axis);
  const double radius = radiusOf(points);
  if (radius > kCompact * std::max(axis.radiusA, axis.radiusB) || isRound(points, radius)) return false;
  const Box3 box = boundingBox(*nut.mesh, nut.X_WB);
  std::vector<RigidBody> near = within(others, box.center(), 0.5 * box.diagonal().norm() + radius);
  if (near.empty()) return true;
  const auto query = CollisionWorld::build(std::move(near), thinner(nut.mesh, kThinner * radius))->makeQuery();
  for (int i = 0; i < kTurns && !stop.stopRequested(); ++i) {
    const Quaternion turn(Eigen::AngleAxisd(kFullTurn * i / kTurns, axis.direction));
    const Vector3 position = axis.point + turn * (nut.X_WB.position - axis.point);
    if (query->collides({position, (turn * nut.X_WB.orientation).normalized()})) return false;
  }
  return true;
}

}  // namespace glissade
