#pragma once

#include <algorithm>

#include "engine/operator/controllers/grasping_hand.h"

namespace glissade {

/// The computer's share at the firmest grip.
inline constexpr double kAlphaOfFirmGrip = 0.1;

/// α while the object is held: the set value at the lightest grip, and smaller the firmer the grip is. A set value
/// below kAlphaOfFirmGrip is not changed.
inline double alphaOfGrip(double set, double squeeze) {
  const double firmness = std::clamp((squeeze - GraspingHand::kLetsGo) / (1.0 - GraspingHand::kLetsGo), 0.0, 1.0);
  return set + firmness * (std::min(set, kAlphaOfFirmGrip) - set);
}

}  // namespace glissade
