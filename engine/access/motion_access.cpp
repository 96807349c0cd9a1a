#include "engine/access/motion_access.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/access/hand_hold.h"
#include "engine/access/object_holds.h"
#include "engine/sequence/tool_shape.h"

namespace glissade {
namespace {

constexpr int kTurns = 12;  ///< of a hand about a handle

constexpr std::size_t kBentBack = 1;  ///< of wristBends(): the forearm is in line with what is pinched

constexpr double kPadLength = 0.012;  ///< metres of an arm's end that are between the pads

Pose turnedAbout(const Vector3& axis, double angle) {
  return {Vector3::Zero(), Quaternion(Eigen::AngleAxisd(angle, axis))};
}

double turnOf(int i, int of) { return 2.0 * std::numbers::pi * i / of; }

/// Holds of one tool, as poses of the grip in the tool's frame.
class ToolHolds {
 public:
  ToolHolds(ToolKind kind, const FastenerHead& head, HandShapes& shapes)
      : shapes_(shapes),
        handle_(handleOf(kind, head)),
        mesh_(std::make_shared<const TriangleMesh>(toolAtRest(kind, head))) {}

  /// The handle is along the axis: its end is in the palm.
  void addBehind(const Pose& X_WT) {
    for (const double tilt : kPinchTilts) {
      const auto& shape = shapes_.pinch({handle_.thickness + kPadGap, 4, tilt});
      if (!shape) continue;
      const double length = (handle_.to - handle_.from).norm();
      const double z = handle_.to.z() - std::min(shape->room, 0.8 * length);
      for (int i = 0; i < kTurns; ++i) {
        const Pose X_TG =
            Pose::translation({0.0, 0.0, z}) * turnedAbout(Vector3::UnitZ(), turnOf(i, kTurns)) * facingIn();
        add(*shape, X_WT, X_TG, kBentBack);
      }
    }
  }

  /// The handle is an arm along x: a fist about its end.
  void addFists(const Pose& X_WT) {
    const HandShapes::Shape& shape = shapes_.fist(handle_.thickness);
    const Vector3 at = handle_.to - 0.45 * shapes_.measures().handBreadth * Vector3::UnitX();
    for (const double end : {1.0, -1.0}) {
      for (int i = 0; i < kTurns; ++i) {
        add(shape, X_WT, Pose::translation(at) * turnedAbout(Vector3::UnitX(), turnOf(i, kTurns)) * barAlongX(end), 0);
      }
    }
  }

  /// Adds holds of the handle's arm between thumb and fingers, from its end or from a side.
  void addPinches(const Pose& X_WT) {
    const Vector3 at = handle_.to - kPadLength * Vector3::UnitX();
    for (const double tilt : kPinchTilts) {
      const auto& shape = shapes_.pinch({handle_.thickness + kPadGap, 2, tilt});
      if (!shape) continue;
      for (int i = 0; i < 4; ++i) {
        const Pose about = Pose::translation(at) * turnedAbout(Vector3::UnitX(), turnOf(i, 4));
        add(*shape, X_WT, about * turnedAbout(Vector3::UnitY(), -0.5 * std::numbers::pi), 0);  // from the end
        const Pose back = Pose::translation({0.0, 0.0, -kPadBack * shapes_.measures().handBreadth});
        for (const Pose& depth : {Pose::identity(), back}) {  // from a side
          add(*shape, X_WT, about * barAlongX(1.0) * depth, 0);
        }
      }
    }
  }

  bool isLongForFist() const { return (handle_.to - handle_.from).norm() >= 1.3 * shapes_.measures().handBreadth; }
  std::vector<HandHold> take() { return std::move(holds_); }

 private:
  void add(const HandShapes::Shape& shape, const Pose& X_WT, const Pose& X_TG, std::size_t bend) {
    holds_.push_back({shape.mesh, X_WT * X_TG * inverse(shape.X_HG), mesh_, X_WT, bend});
  }
  /// The grip's y, along which a bar lies in a fist, is the tool's x or against it.
  static Pose barAlongX(double end) { return turnedAbout(Vector3::UnitZ(), -end * 0.5 * std::numbers::pi); }
  /// The grip looks along -z, to the head.
  static Pose facingIn() { return turnedAbout(Vector3::UnitX(), std::numbers::pi); }

  HandShapes& shapes_;
  ToolHandle handle_;
  MeshPtr mesh_;
  std::vector<HandHold> holds_;
};

/// Ways to hold a tool on a fastener's head: a screwdriver by its handle with the forearm behind it, another tool in a
/// fist at the end of its arm, where that is longer than a hand is broad, or between thumb and fingers; with the
/// handle in all positions. `X_WT`: the tool's frame with its handle in the first position.
std::vector<HandHold> toolHolds(ToolKind kind, const FastenerHead& head, const Pose& X_WT, HandShapes& shapes) {
  ToolHolds holds(kind, head, shapes);
  const int positions = handlePositions(kind);
  for (int i = 0; i < positions; ++i) {
    const Pose turned = X_WT * turnedAbout(Vector3::UnitZ(), turnOf(i, positions));
    if (kind == ToolKind::Screwdriver) {
      holds.addBehind(turned);
    } else if (holds.isLongForFist()) {
      holds.addFists(turned);
    }
  }
  for (int i = 0; kind != ToolKind::Screwdriver && i < positions; ++i) {
    holds.addPinches(X_WT * turnedAbout(Vector3::UnitZ(), turnOf(i, positions)));
  }
  return holds.take();
}

/// Angle of one swing of a handle, which turns a fastener (tool_shape.h).
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
  if (!turnsHead(motion.tool)) return std::nullopt;
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
  grip.question.holds = objectHolds(bodies_W, leaving, motion.up, search_.shapes());
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
  const std::vector<Vector3> eyes =
      person_.eye ? std::vector<Vector3>{*person_.eye} : eyesAbout(boundingBox(bodies_W), motion.up);
  const HandAnswer hand = search_.find(grip.question, stop);
  return {hand, grip.follow, grip.tool, sight_.of(bodies_W, eyes, motion.others), std::move(grip.question.samples)};
}

}  // namespace glissade
