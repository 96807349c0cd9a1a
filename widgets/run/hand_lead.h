#pragma once

#include <QString>

#include <vector>

#include "engine/operator/device_shaping.h"
#include "widgets/devices/steering_keys.h"

namespace glissade {

/// A key to hold, and the motion until then: metres or radians.
struct KeyToHold {
  const SteeringKey* key;
  double way;
};

/// Velocity of the object while only this key is held. `frame`: see shapedFrame().
Twist twistOf(const SteeringKey& key, const DeviceShaping& shaping, const OperatorFrame& frame);

/// The keys that lead the object from one pose to another: first the moves, then the turns, the longest first. A move
/// or a turn that is much shorter than the longest one is left out; it becomes the longest one later.
std::vector<KeyToHold> keysToHold(const Pose& from, const Pose& to, const DeviceShaping& shaping,
                                  const OperatorFrame& frame, double objectRadius);

/// "D: right 300 mm · O: roll right 8°", in the user's language. Numbers have one digit, because people read them while
/// they steer. Without letters for devices that have none.
QString textOf(const std::vector<KeyToHold>& keys, bool withLetters);

/// "A: left · W: up", in the user's language; without letters for devices that have none.
QString textOf(const std::vector<const SteeringKey*>& keys, bool withLetters);

/// The move and the turn between two poses, with two digits: "1.3 m, 95°".
QString distanceText(const Pose& from, const Pose& to);

}  // namespace glissade
