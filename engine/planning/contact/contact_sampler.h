#pragma once

#include <cstdint>

#include "engine/base/random_stream.h"
#include "engine/planning/operator_sample.h"

namespace glissade {

/// ContactSampling() of paper 1 (sections II.B and II.C): configurations on the local tangent plane
/// of the nearest obstacle, the orientation frozen at the operator's.
///
///   p = c - n (dist - gap) + u t1 + v t2,   n = (P_n - P_o) / |P_n - P_o|
///
/// with c the device position, (t1, t2) a Gram-Schmidt frame of the plane, and (u, v) uniform in a
/// disc. Deviation: the paper's software has an offset that is wrong for oblique normals, and no
/// gap; ours keeps the object `gap` away from the plane so that a sample touches without penetrating.
class ContactSampler {
 public:
  explicit ContactSampler(std::uint64_t seed) : stream_(seed, "contact sampler") {}

  /// Freezes plane and orientation. Precondition: operatorSample.nearest.distance > 0.
  void enter(const OperatorSample& operatorSample, double gap, double discRadius);
  /// The next sample on the plane entered last.
  Pose sample();

 private:
  RandomStream stream_;
  Pose origin_;  ///< q_device moved along the normal until only the gap is left
  Vector3 t1_ = Vector3::UnitX();
  Vector3 t2_ = Vector3::UnitY();
  double discRadius_ = 0.0;
};

}  // namespace glissade
