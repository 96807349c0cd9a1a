#pragma once

#include "engine/base/parameters.h"

namespace glissade {

/// Bits of ParameterId::Tuning: the settings that are tuned automatically.
enum TunedSetting : int { kTunedAlpha = 1, kTunedContactSamples = 2, kTunedContactDistance = 4, kTunedAll = 7 };

/// The bit of a parameter; 0 where it is never tuned automatically.
constexpr int tunedSetting(ParameterId id) {
  switch (id) {
    case ParameterId::Alpha: return kTunedAlpha;
    case ParameterId::ContactSamples: return kTunedContactSamples;
    case ParameterId::ContactDistance: return kTunedContactDistance;
    default: return 0;
  }
}

/// The settings of the interaction in Algorithm 1 (paper 1).
struct InteractionSettings {
  double alpha = 0.0;            ///< the computer's share of the iterations
  int contactSamples = 0;        ///< N
  double contactDistance = 0.0;  ///< d, metres

  /// The setting of a parameter; 0 for any other parameter.
  double operator[](ParameterId id) const {
    switch (id) {
      case ParameterId::Alpha: return alpha;
      case ParameterId::ContactSamples: return contactSamples;
      case ParameterId::ContactDistance: return contactDistance;
      default: return 0.0;
    }
  }
};

/// The user's values, with the automatic settings replaced by the tuned ones.
inline InteractionSettings settingsInForce(const ParameterValues& parameters, const InteractionSettings& tuned) {
  const int bits = parameters.integer(ParameterId::Tuning);
  InteractionSettings inForce = tuned;
  if ((bits & kTunedAlpha) == 0) inForce.alpha = parameters[ParameterId::Alpha];
  if ((bits & kTunedContactSamples) == 0) inForce.contactSamples = parameters.integer(ParameterId::ContactSamples);
  if ((bits & kTunedContactDistance) == 0) inForce.contactDistance = parameters[ParameterId::ContactDistance];
  return inForce;
}

/// The settings that a tuner has chosen in a run. A setting that is not automatic has the value that the tuner would
/// choose.
struct TuningReport {
  InteractionSettings now;
  InteractionSettings median;  ///< median over the steps that the tuner has seen
};

}  // namespace glissade
