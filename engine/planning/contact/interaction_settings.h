#pragma once

#include "engine/base/parameters.h"

namespace glissade {

/// The bits of ParameterId::Tuning: what sets itself.
enum TunedSetting : int { kTunedAlpha = 1, kTunedContactSamples = 2, kTunedContactDistance = 4, kTunedAll = 7 };

/// The bit of a parameter; 0 where it never sets itself.
constexpr int tunedSetting(ParameterId id) {
  switch (id) {
    case ParameterId::Alpha: return kTunedAlpha;
    case ParameterId::ContactSamples: return kTunedContactSamples;
    case ParameterId::ContactDistance: return kTunedContactDistance;
    default: return 0;
  }
}

/// What tunes the interaction of Algorithm 1 (paper 1).
struct InteractionSettings {
  double alpha = 0.0;            ///< the computer's share of the iterations
  int contactSamples = 0;        ///< N
  double contactDistance = 0.0;  ///< d, metres

  /// By parameter; 0 of any other.
  double operator[](ParameterId id) const {
    switch (id) {
      case ParameterId::Alpha: return alpha;
      case ParameterId::ContactSamples: return contactSamples;
      case ParameterId::ContactDistance: return contactDistance;
      default: return 0.0;
    }
  }
};

/// The user's values, but what sets itself.
inline InteractionSettings settingsInForce(const ParameterValues& parameters, const InteractionSettings& tuned) {
  const int bits = parameters.integer(ParameterId::Tuning);
  InteractionSettings inForce = tuned;
  if ((bits & kTunedAlpha) == 0) inForce.alpha = parameters[ParameterId::Alpha];
  if ((bits & kTunedContactSamples) == 0) inForce.contactSamples = parameters.integer(ParameterId::ContactSamples);
  if ((bits & kTunedContactDistance) == 0) inForce.contactDistance = parameters[ParameterId::ContactDistance];
  return inForce;
}

/// What a tuner has set in a run. Of what it was not asked to set: what it would have.
struct TuningReport {
  InteractionSettings now;
  InteractionSettings median;  ///< over the steps that the tuner has seen
};

}  // namespace glissade
