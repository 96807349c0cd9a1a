#include "engine/fits/fit_thread.h"

#include "engine/fits/loose_nut.h"
#include "engine/fits/thread_pitch.h"

namespace glissade {
namespace {

/// The ends in which the object's axis is the same line as in the first one. In other ends its thread may be in another
/// hole of the obstacle.
std::vector<Pose> onAxis(const ContactAxis& axis, const Pose& first, const std::vector<Pose>& ends) {
  constexpr double kSame = 1e-5;
  const Vector3 point_B = inverse(first) * axis.point;
  std::vector<Pose> same{first};
  for (const Pose& end : ends) {
    const Vector3 p = end * point_B - axis.point;
    const Vector3 direction = end.orientation * (first.orientation.conjugate() * axis.direction);
    const bool isSame = p.cross(axis.direction).norm() < kSame && direction.cross(axis.direction).norm() < kSame;
    if (isSame && end != first) same.push_back(end);
  }
  return same;
}

bool mayTurn(const ThreadRule& rule, const ThreadQuestion& question, const StopToken& stop) {
  const std::vector<RigidBody>& bodies = question.product.bodies;
  const FitEdit* edit = question.edit;
  if (edit != nullptr && !edit->turned.empty()) return edit->turned == bodies[question.object].id;
  if (!rule.objectIsShaft) return true;
  std::vector<const RigidBody*> others;
  const auto nut = static_cast<std::size_t>(rule.obstacle);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (i != nut && i != question.object) others.push_back(&bodies[i]);
  }
  return !isLooseNut(bodies[nut], *question.contact.axis, others, stop);
}

}  // namespace

FitThread fitThreadOf(const ThreadQuestion& question, const StopToken& stop) {
  const ContactAxis& axis = *question.contact.axis;
  FitThread thread;
  ThreadRule& rule = thread.rule;
  rule.obstacle = static_cast<int>(question.contact.a);
  rule.point_W = axis.point;
  rule.axis_W = axis.direction.normalized();
  rule.radiusOfObstacle = axis.radiusA;
  rule.radiusOfObject = axis.radiusB;
  rule.objectIsShaft = !axis.shaftIsA;
  rule.assembled = onAxis(axis, question.measuredAt, question.ends);
  rule.mayTurn = mayTurn(rule, question, stop);
  if (question.edit != nullptr && question.edit->pitch) {
    rule.pitch = *question.edit->pitch;
    return thread;
  }
  const ThreadPitch coarse = coarsePitch(rule.objectIsShaft ? axis.radiusB : axis.radiusA);
  rule.pitch = coarse.pitch;
  thread.size = coarse.size;
  return thread;
}

evidence::StatedThread statedThread(const ThreadRule& rule) {
  return {rule.point_W, rule.axis_W, rule.pitch, rule.radiusOfObject, rule.radiusOfObstacle};
}

}  // namespace glissade
