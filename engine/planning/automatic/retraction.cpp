#include "engine/planning/automatic/retraction.h"

namespace glissade {
namespace {

constexpr int kMostSteps = 24;
/// Factor of the required clearance: a contact that is opened by exactly the clearance is closed again by the next
/// step.
constexpr double kOvershoot = 1.2;

}  // namespace

std::optional<Pose> retracted(CollisionQuery& query, const Pose& q, double clearance, double radius) {
  Pose result = q;
  for (int step = 0; step < kMostSteps; ++step) {
    const NearestObstacle nearest = query.nearestObstacle(result);
    if (nearest.distance >= clearance) return result;
    if (nearest.distance <= 0.0) return std::nullopt;
    const Vector3 n = nearest.normal_W();
    // Turning by w about the reference point moves the contact by w x arm.
    const Vector3 arm = nearest.p_WPn - result.position;
    const Vector3 lever = arm.cross(n);
    const double rate = 1.0 + lever.squaredNorm() / (radius * radius);
    const double by = kOvershoot * (clearance - nearest.distance) / rate;
    result.position += by * n;
    const Vector3 turn = by / (radius * radius) * lever;
    const double angle = turn.norm();
    if (angle > 0.0) {
      result.orientation = (Quaternion(Eigen::AngleAxisd(angle, turn / angle)) * result.orientation).normalized();
    }
  }
  return std::nullopt;
}

}  // namespace glissade
