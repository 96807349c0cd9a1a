// Values that the tests of the public library share.
#pragma once

#include <glissade/glissade.h>

#include <limits>

namespace glissade::test {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

inline Pose at(double x, double y, double z) { return {{x, y, z}, Quaternion::Identity()}; }

}  // namespace glissade::test
