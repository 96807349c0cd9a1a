#pragma once

#include <cmath>

#include "engine/base/random_stream.h"
#include "engine/geometry/pose.h"

namespace glissade {

/// A normally distributed vector without a preferred direction. `sigma` is the root mean square of its length.
inline Vector3 isotropicNoise(RandomStream& stream, double sigma) {
  const double perAxis = sigma / std::sqrt(3.0);
  const double x = stream.normal();
  const double y = stream.normal();
  const double z = stream.normal();
  return perAxis * Vector3(x, y, z);
}

}  // namespace glissade
