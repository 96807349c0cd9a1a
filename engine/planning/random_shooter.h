#pragma once

#include "engine/base/random_stream.h"
#include "engine/geometry/pose.h"

namespace glissade {

/// Random_Shooter() of Algorithm 1: position uniform in the bounds, orientation uniform in SO(3)
/// (Shoemake 1992).
class RandomShooter {
 public:
  RandomShooter(const Box3& bounds, std::uint64_t seed) : bounds_(bounds), stream_(seed, "random shooter") {}

  Pose shoot();

 private:
  Box3 bounds_;
  RandomStream stream_;
};

}  // namespace glissade
