#include "widgets/instruction/step_motion_picture.h"

#include <algorithm>

#include "engine/sequence/plan_bodies.h"
#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

/// What comes is drawn farther away than it is long.
constexpr double kClear = 1.1;

}  // namespace

StepMotionPicture stepMotionPicture(const AssemblyStep& step, const AssembledProduct& product, double apart) {
  StepMotionPicture picture;
  const Vector3 direction = exitDirection(step.path);
  Box3 box;
  double least = 0.0;
  double most = 0.0;
  bool isFirst = true;
  for (const std::size_t index : bodiesOf(step, product)) {
    const RigidBody& body = product.bodies[index];
    for (const Vector3& vertex : body.mesh->vertices) {
      const Vector3 p_W = body.X_WB * vertex;
      const double along = direction.dot(p_W);
      box.extend(p_W);
      least = isFirst ? along : std::min(least, along);
      most = isFirst ? along : std::max(most, along);
      isFirst = false;
    }
  }
  picture.along = most - least;
  const Vector3 middle = box.center();
  const double wanted = std::max(apart, kClear * picture.along);
  const Pose X_PW = inverse(step.path.front().q);  // of the path's frame at the place
  picture.way = {middle};
  double length = 0.0;
  for (std::size_t i = 1; i < step.path.size() && length < wanted; ++i) {
    const Pose& from = step.path[i - 1].q;
    const Pose& to = step.path[i].q;
    const double leg = ((to * X_PW) * middle - (from * X_PW) * middle).norm();
    const double share = leg > 0.0 ? std::min(1.0, (wanted - length) / leg) : 1.0;
    picture.moved = interpolate(from, to, share) * X_PW;
    picture.way.push_back(picture.moved * middle);
    length += leg;
  }
  std::reverse(picture.way.begin(), picture.way.end());
  return picture;
}

}  // namespace glissade
