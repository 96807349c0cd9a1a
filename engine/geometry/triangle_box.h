#pragma once

#include <array>

#include "engine/geometry/pose.h"

namespace glissade {

/// Whether a triangle reaches into the interior of the cube about `centre` with half edge `half`
/// (separating axes; Akenine-Moller 2001). Touching does not count.
bool triangleEntersCube(const std::array<Vector3, 3>& triangle, const Vector3& centre, double half);

}  // namespace glissade
