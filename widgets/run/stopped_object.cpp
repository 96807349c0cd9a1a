#include "widgets/run/stopped_object.h"

#include "engine/collision/contact_planes.h"
#include "widgets/run/hand_lead.h"

namespace glissade {
namespace {

/// Time without a motion after which an object is stopped.
constexpr double kMilliseconds = 300.0;
/// Longest motion of a stopped object in that time, in radii: it hardly slides.
constexpr double kNoMotion = 0.03;
/// Length of a move that has to be free, in radii of the object.
constexpr double kFreeMove = 0.1;

}  // namespace

bool StoppedObject::note(const OperatorSample& sample, double objectRadius, double milliseconds) {
  if (!sample.hand) {
    at_.reset();
    return false;
  }
  if (!at_ || longestWay(*at_, sample.q_device, objectRadius) > kNoMotion * objectRadius) {
    at_ = sample.q_device;
    since_ = milliseconds;
  }
  return milliseconds - since_ >= kMilliseconds;
}

std::vector<const SteeringKey*> freeMoves(const Pose& q, const DeviceShaping& shaping, const OperatorFrame& frame,
                                          CollisionQuery& query, double objectRadius) {
  const OperatorFrame shaped = shapedFrame(shaping, {q, frame, {}, 0, {}, {}});
  std::vector<const SteeringKey*> keys;
  for (const SteeringKey& key : steeringKeys()) {
    const Vector3 velocity = twistOf(key, shaping, shaped).linear_W;
    if (velocity.isZero()) continue;
    const auto isFree = [&](double share) {
      Pose moved = q;
      moved.position += share * kFreeMove * objectRadius * velocity.normalized();
      return query.nearestObstacle(moved).distance > 0.0;
    };
    if (isFree(0.5) && isFree(1.0)) keys.push_back(&key);
  }
  return keys;
}

}  // namespace glissade
