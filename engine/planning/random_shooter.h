#pragma once

#include "engine/base/random_stream.h"
#include "engine/planning/problem.h"

namespace glissade {

/// Random_Shooter() of Algorithm 1: position uniform in the problem's region, or its bounds where it
/// has none, orientation uniform in SO(3) (Shoemake 1992). A problem with a source draws from that instead.
class RandomShooter {
 public:
  RandomShooter(const Problem& problem, std::uint64_t seed)
      : bounds_(problem.bounds),
        region_(problem.region),
        source_(region_ ? ConfigurationSource() : problem.source),
        seed_(seed),
        stream_(seed, "random shooter") {}

  Pose shoot();
  /// Draws an orientation uniformly in SO(3).
  static Quaternion orientation(RandomStream& stream);

 private:
  Box3 bounds_;
  SamplingRegionPtr region_;
  ConfigurationSource source_;
  std::uint64_t seed_;
  ConfigurationDraw draw_;  ///< made by the source at the first draw
  RandomStream stream_;
};

}  // namespace glissade
