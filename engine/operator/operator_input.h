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

/// Mapping of deflections to motion. The window sets it; the latest one counts.
struct OperatorFrame {
  Quaternion R_WV = Quaternion::Identity();  ///< orientation of the view V (x right, y up, z to the eye)
  OperatorSpeed speed;                       ///< speed at full deflection; scales with the object's size
};

/// Speeds at full deflection for a view. The object crosses a view of this height (metres, at the object) in the same
/// time for any zoom, but never slower than a twentieth of its radius per second nor faster than five radii.
OperatorSpeed operatorSpeed(double viewHeight, double objectRadius);

/// The twist of a view-relative deflection.
Twist toTwist(const Deflection& deflection, const OperatorFrame& frame);

/// Information for an operator who decides how to move.
struct OperatorView {
  Pose q_device;  ///< pose of the object in the hand
  OperatorFrame frame;
  /// Distance in the metric from q to the nearest node of the start tree; never empty.
  std::function<double(const Pose& q)> distanceToStartTree;
  /// Number of nodes from contact sampling; while it grows the operator sees the tree slide.
  std::uint64_t contactNodes = 0;
  /// Distance from the object in the hand to the nearest obstacle.
  std::function<double()> clearance;
  Guidance guidance{};  ///< guidance that a haptic device renders
};

/// A person or a simulated operator: turns time into motion. Not thread-safe: owned and called by the operator thread
/// (or by the lockstep loop), and must return at once.
class OperatorDevice {
 public:
  virtual ~OperatorDevice() = default;

  /// q_device after the next dt seconds (integrated in our own clock; clamped to `bounds`). Equal to view.q_device when
  /// at rest. Devices that a person holds, and haptic devices, stop at obstacles (SlidingHand); simulated operators do
  /// not.
  virtual Pose advance(double dt, const OperatorView& view, const Box3& bounds) = 0;
  /// Begins a new run with the object at the start. A device with a plan begins it anew.
  virtual void restart() {}
  /// Another source has moved the object; a hand that holds the object holds it at its new pose.
  virtual void regrip() {}
  /// True if the device holds the object at its own pose, even at rest. Other devices move it, and release it when they
  /// are at rest.
  virtual bool holds() const { return false; }
  /// Sets the obstacles' force, in shares (see rendered()); nothing: the object is free.
  virtual void feel(const std::optional<Wrench>& /*pushedBack*/) {}
  /// False while the device is disconnected; it may reconnect.
  virtual bool connected() const { return true; }
  /// True for a simulated person, who rests once a run has ended. A person may move the object then.
  virtual bool isSimulated() const { return false; }
  /// The wrench that the device renders on the hand, in shares (see Guidance); nothing: it renders no force.
  virtual std::optional<Wrench> rendered() const { return std::nullopt; }
  /// Pose of the object to which the hand leads, where obstacles hold the object back; nothing: the object is there.
  virtual std::optional<Pose> hand() const { return std::nullopt; }
};

/// The pose after dt seconds of the twist; exactly X_WB when the twist is zero. The position is clamped to the bounds.
Pose integrate(const Pose& X_WB, const Twist& twist, const Box3& bounds, double dt);

}  // namespace glissade
