#include "widgets/contacts/joint_draft.h"

#include <algorithm>
#include <cmath>

#include "engine/fits/joint_edits.h"
#include "engine/fits/product_shapes.h"
#include "engine/fits/thread_pitch.h"

namespace glissade {
namespace {

constexpr double kUsualDiameter = 5e-3;  ///< metres, for a body without a shaft and a hole
/// Engaged length of a thread in diameters, if the shape does not give it.
constexpr double kUsualEngaged = 1.5;

/// A product of these bodies only, with the leaving body first: shapes of a whole product take longer.
AssembledProduct partOf(const AssembledProduct& product, const std::vector<std::size_t>& bodies, std::size_t body) {
  AssembledProduct part;
  part.bodies.push_back(product.bodies[body]);
  for (const std::size_t other : bodies) {
    if (other != body) part.bodies.push_back(product.bodies[other]);
  }
  part.deflections.assign(part.bodies.size(), 0.0);
  return part;
}

std::size_t smallestOf(const AssembledProduct& product, const std::vector<std::size_t>& bodies) {
  const auto size = [&](std::size_t body) {
    return boundingBox(*product.bodies[body].mesh, product.bodies[body].X_WB).diagonal().norm();
  };
  return *std::min_element(bodies.begin(), bodies.end(),
                           [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
}

JointKind kindOf(const TurnedShape* shape, bool isAlone) {
  if (isAlone) return JointKind::Flexible;
  if (shape == nullptr) return JointKind::Permanent;
  switch (shape->kind) {
    case TurnedKind::Screw:
    case TurnedKind::SetScrew: return JointKind::Screw;
    case TurnedKind::Nut: return JointKind::Nut;
    case TurnedKind::Ring: return JointKind::Insert;
    case TurnedKind::Rod: break;
  }
  return JointKind::Pin;
}

JointThread threadOf(const TurnedShape* shape) {
  const double radius = shape == nullptr ? 0.0 : std::max(shape->shaft, shape->hole);
  JointThread thread;
  thread.diameter = radius > 0.0 ? 2.0 * radius : kUsualDiameter;
  thread.pitch = coarsePitch(0.5 * thread.diameter).pitch;
  thread.engaged = kUsualEngaged * thread.diameter;
  if (shape != nullptr && shape->kind == TurnedKind::Nut) thread.engaged = shape->length();
  return thread;
}

/// The vector from the middle of the others to the middle of the body.
Vector3 awayFromOthers(const ProductShapes& shapes) {
  Box3 box;
  for (std::size_t other = 1; other < shapes.size(); ++other) box.extend(shapes.box(other));
  return shapes.size() > 1 ? Vector3(shapes.box(0).center() - box.center()) : Vector3(Vector3::UnitZ());
}

/// The axis nearest to a direction.
Vector3 alongAnAxis(const Vector3& way) {
  Eigen::Index axis = 2;
  way.cwiseAbs().maxCoeff(&axis);
  return std::copysign(1.0, way[axis]) * Vector3::Unit(axis);
}

void addAxis(const ProductShapes& shapes, Joint& joint) {
  const Vector3 way = awayFromOthers(shapes);
  joint.point = shapes.box(0).center();
  joint.direction = alongAnAxis(way);
  const TurnedShape* shape = shapes.turned(0);
  if (shape == nullptr) return;
  const AxisLine axis = shapes.axisOf(0);
  joint.point = axis.point;
  const bool hasHead = shape->kind == TurnedKind::Screw || shape->kind == TurnedKind::SetScrew;
  joint.direction = hasHead || axis.direction.dot(way) >= 0.0 ? axis.direction : Vector3(-axis.direction);
}

}  // namespace

Joint draftJoint(const AssembledProduct& product, const std::vector<std::size_t>& bodies,
                 std::optional<std::size_t> body) {
  Joint joint;
  joint.body = body.value_or(smallestOf(product, bodies));
  std::copy_if(bodies.begin(), bodies.end(), std::back_inserter(joint.others),
               [&](std::size_t other) { return other != joint.body; });
  const AssembledProduct part = partOf(product, bodies, joint.body);
  const ProductShapes shapes(part);
  joint.kind = kindOf(shapes.turned(0), joint.others.empty());
  joint.thread = threadOf(shapes.turned(0));
  addAxis(shapes, joint);
  return joint;
}

JointEdit editForJoint(Joint joint, const AssembledProduct& product) {
  joint.state = JointState::Confirmed;
  joint.isDoubtful = false;
  joint.evidence.clear();
  if (!isScrewed(joint.kind)) {
    joint.others.insert(joint.others.end(), joint.clamped.begin(), joint.clamped.end());
    joint.clamped.clear();
    joint.thread.reset();
    joint.drive = DriveKind::None;
    joint.driveSize = 0.0;
  }
  if (joint.thread) joint.thread->isPitchStated = true;
  if (joint.kind != JointKind::Snap) joint.bend = 0.0;
  JointEdit word{keyOf(joint, product), JointEdit::Word::Confirmed, joint};
  for (const std::size_t body : joint.clamped) word.clamped.push_back(product.bodies[body].id);
  return word;
}

}  // namespace glissade
