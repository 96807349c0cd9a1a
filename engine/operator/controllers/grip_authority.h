#pragma once

#include <algorithm>

#include "engine/operator/controllers/grasping_hand.h"

namespace glissade {

/// The computer's least share, of the firmest grip.
inline constexpr double kAlphaOfFirmGrip = 0.1;

/// α while the object is held: as it was set where the grip is as light as can be, and the less of it the firmer the
/// grip is. A value that was set below the least one stays.
inline double alphaOfGrip(double set, double squeeze) {
  const double firmness = std::clamp((squeeze - GraspingHand::kLetsGo) / (1.0 - GraspingHand::kLetsGo), 0.0, 1.0);
  return set + firmness * (std::min(set, kAlphaOfFirmGrip) - set);
}

}  // namespace glissade
