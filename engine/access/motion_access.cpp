#include "engine/access/motion_access.h"

#include <numbers>
#include <utility>

#include "engine/access/object_holds.h"
#include "engine/access/tool_holds.h"

namespace glissade {
namespace {

/// Of a handle, on each of which a fastener is turned (tool_shape.h).
constexpr double kSwing = std::numbers::pi / 3.0;
/// Metres before its place from which a body may be pushed with a finger.
constexpr double kPushed = 0.015;

TriangleMesh meshOf(const std::vector<std::size_t>& choice, const std::vector<RigidBody>& bodies) {
  TriangleMesh mesh_W;
  for (const std::size_t body : choice) append(mesh_W, transformed(*bodies[body].mesh, bodies[body].X_WB));
  return mesh_W;
}

/// Unit, from where the motion begins to where it ends; zero where it comes back.
Vector3 leavingOf(const std::vector<Pose>& moved, const Vector3& middle) {
  const Vector3 way = moved.back() * middle - middle;
  return way.norm() > 1e-9 ? Vector3(way.normalized()) : Vector3(Vector3::Zero());
}

/// Samples before the first one that has moved so far; 0 where none has.
std::size_t samplesWithin(double distance, const std::vector<HandSample>& samples, const Vector3& middle) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if ((samples[i].moved * middle - middle).norm() >= distance) return i;
  }
  return 0;
}

/// The turn about the z axis of a frame, as a motion in the world.
Pose turnedAbout(const Pose& X_WT, double angle) {
  const Pose turn{Vector3::Zero(), Quaternion(Eigen::AngleAxisd(angle, Vector3::UnitZ()))};
  return X_WT * turn * inverse(X_WT);
}

}  // namespace

/// How something is held, and the way of the hand.
struct AccessChecker::Grip {
  ToolKind tool = ToolKind::None;
  HandFollow follow;
  HandQuestion question;
};

AccessChecker::AccessChecker(const std::vector<RigidBody>& bodies, const Person& person)
    : person_(person), bodies_(bodies), search_(bodies_, person.size), sight_(bodies) {}

/// The tool stays on the head, and its handle is swung before the motion begins. At a bolt whose nut is held it swings
/// only: the bolt stays.
std::optional<AccessChecker::Grip> AccessChecker::toolGripOf(const ReachedMotion& motion, const Vector3& leaving) {
  if (motion.tool == ToolKind::None) return std::nullopt;
  const RigidBody& fastener = bodies_.bodies()[motion.bolt.value_or(motion.bodies.front())];
  const auto head = headOf(*fastener.mesh);
  if (!head) return std::nullopt;
  const Pose X_WT = toolFrame(*head, fastener.X_WB, leaving, 0.0);
  Grip grip;
  grip.tool = motion.tool;
  grip.follow = motion.bolt ? HandFollow::still() : HandFollow::point(X_WT.position);
  grip.question.holds = toolHolds(motion.tool, *head, X_WT, search_.shapes());
  for (const double share : {0.5, 1.0}) grip.question.samples.push_back({turnedAbout(X_WT, share * kSwing), 0.0});
  const std::vector<HandSample> way = samplesOf(motion.moved, grip.follow, X_WT.position);
  grip.question.samples.insert(grip.question.samples.end(), way.begin(), way.end());
  return grip;
}

AccessChecker::Grip AccessChecker::gripOf(const ReachedMotion& motion, const TriangleMesh& bodies_W) {
  const Vector3 middle = boundingBox(bodies_W).center();
  const Vector3 leaving = leavingOf(motion.moved, middle);
  if (auto grip = toolGripOf(motion, leaving)) return std::move(*grip);
  Grip grip;
  grip.follow = followOf(motion.moved, middle);
  grip.question.holds = objectHolds(bodies_W, leaving, search_.shapes());
  grip.question.samples = samplesOf(motion.moved, grip.follow, middle);
  grip.question.gripped = motion.bodies;
  grip.question.pushed = samplesWithin(kPushed, grip.question.samples, middle);
  if (grip.question.pushed > 0) grip.question.pushes = pushHolds(bodies_W, leaving, search_.shapes());
  return grip;
}

MotionAccess AccessChecker::of(const ReachedMotion& motion, const StopToken& stop) {
  const TriangleMesh bodies_W = meshOf(motion.bodies, bodies_.bodies());
  Grip grip = gripOf(motion, bodies_W);
  grip.question.obstacles = motion.others;
  const std::vector<Vector3> eyes = person_.eye ? std::vector<Vector3>{*person_.eye} : eyesAbout(boundingBox(bodies_W));
  const HandAnswer hand = search_.find(grip.question, stop);
  return {hand, grip.follow, grip.tool, sight_.of(bodies_W, eyes, motion.others), std::move(grip.question.samples)};
}

}  // namespace glissade
