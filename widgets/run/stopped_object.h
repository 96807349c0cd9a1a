#pragma once

#include <optional>
#include <vector>

#include "engine/operator/device_shaping.h"
#include "engine/planning/operator_sample.h"
#include "widgets/devices/steering_keys.h"

namespace glissade {

/// Notices that obstacles stop the object although the hand leads it on. An object that slides is not stopped.
class StoppedObject {
 public:
  /// Takes the latest sample, which was made this many milliseconds after a fixed moment. True if the object has stayed
  /// where it is for a while.
  bool note(const OperatorSample& sample, double objectRadius, double milliseconds);

 private:
  std::optional<Pose> at_;  ///< nothing: the hand does not lead
  double since_ = 0.0;      ///< milliseconds
};

/// The keys that move the object, without turning it, by a part of its radius without a collision.
std::vector<const SteeringKey*> freeMoves(const Pose& q, const DeviceShaping& shaping, const OperatorFrame& frame,
                                          CollisionQuery& query, double objectRadius);

}  // namespace glissade
