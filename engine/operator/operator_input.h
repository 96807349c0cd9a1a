#pragma once

#include <cstdint>
#include <functional>

#include "engine/collision/collision_query.h"
#include "engine/geometry/pose.h"
#include "engine/operator/guidance.h"

namespace glissade {

/// Deflection of a device on its six axes, each in [-1, 1]: translation x y z, rotation x y z, in
/// the device's own frame (x right, y up, z towards the person). A rate command, as a 6D mouse gives.
struct Deflection {
  Vector3 translation = Vector3::Zero();
  Vector3 rotation = Vector3::Zero();

  bool atRest() const { return translation.isZero() && rotation.isZero(); }
};

/// Velocity of the object about its reference point, world frame.
struct Twist {
  Vector3 linear_W = Vector3::Zero();   ///< m/s
  Vector3 angular_W = Vector3::Zero();  ///< rad/s

  bool atRest() const { return linear_W.isZero() && angular_W.isZero(); }
};

/// Speeds at full deflection.
struct OperatorSpeed {
  double linear = 1.0;   ///< m/s
  double angular = 1.5;  ///< rad/s
};

/// How deflections become motion: set by the window, latest wins.
struct OperatorFrame {
  Quaternion R_WV = Quaternion::Identity();  ///< orientation of the view V (x right, y up, z to the eye)
  OperatorSpeed speed;                       ///< at full deflection; scales with the object's size
};

/// Speeds at full deflection that suit what is seen: the object crosses a view of this height (metres,
/// where the object is) at the same pace whatever the zoom, but never by less than a twentieth of its
/// radius a second nor by more than five.
OperatorSpeed operatorSpeed(double viewHeight, double objectRadius);

/// The twist of a view-relative deflection.
Twist toTwist(const Deflection& deflection, const OperatorFrame& frame);

/// What an operator can see when he decides how to move.
struct OperatorView {
  Pose q_device;  ///< where the object is in his hand
  OperatorFrame frame;
  /// Distance in the metric from q to the nearest node of the start tree; never empty.
  std::function<double(const Pose& q)> distanceToStartTree;
  /// Nodes that contact sampling has brought: as long as their number grows he sees the tree slide.
  std::uint64_t contactNodes = 0;
  /// Distance from the object in his hand to the nearest obstacle.
  std::function<double()> clearance;
  Guidance guidance{};  ///< what a device that pushes back renders
};

/// A person, or whatever stands in for one: turns time into motion. Not thread-safe: owned and
/// called by the operator thread (or by the lockstep loop), and must return at once.
class OperatorDevice {
 public:
  virtual ~OperatorDevice() = default;

  /// q_device after the next dt seconds (integrated in our own clock; clamped to `bounds`). Equal to view.q_device when
  /// at rest. What a person holds, and haptic devices, stop at obstacles (SlidingHand); simulated operators do not.
  virtual Pose advance(double dt, const OperatorView& view, const Box3& bounds) = 0;
  /// A new run begins with the object at the start: whoever follows a plan begins it anew.
  virtual void restart() {}
  /// The object was put elsewhere by somebody else: a hand that holds it holds it there.
  virtual void regrip() {}
  /// Holds the object at a place of its own, at rest, too. Others move it, and let it go when they are at rest.
  virtual bool holds() const { return false; }
  /// What the obstacles push back with from now on, in shares (see rendered()); nothing: the object is free.
  virtual void feel(const std::optional<Wrench>& /*pushedBack*/) {}
  /// False while the device is away (daemon dead, cable out); it may come back.
  virtual bool connected() const { return true; }
  /// Stands in for a person, and rests once a run has ended. A person may move the object then.
  virtual bool isSimulated() const { return false; }
  /// What the device makes the hand feel, in shares (see Guidance); nothing: it renders no force.
  virtual std::optional<Wrench> rendered() const { return std::nullopt; }
  /// Where the hand has moved the object, where obstacles keep the object from coming after it; nothing: it is there.
  virtual std::optional<Pose> hand() const { return std::nullopt; }
};

/// q_device after dt seconds of the twist; exactly X_WB when the twist is at rest. The position is
/// clamped to the bounds.
Pose integrate(const Pose& X_WB, const Twist& twist, const Box3& bounds, double dt);

}  // namespace glissade
