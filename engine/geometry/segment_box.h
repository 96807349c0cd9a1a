#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// True if the segment that begins at `from` and ends at `from + way` meets the box.
inline bool segmentMeets(const Box3& box, const Vector3& from, const Vector3& way) {
  double enter = 0.0;
  double leave = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1.0 / way[axis];
    double one = (box.min()[axis] - from[axis]) * inverse;
    double other = (box.max()[axis] - from[axis]) * inverse;
    if (std::isnan(one) || std::isnan(other)) continue;  // the segment is along a side of the box
    if (one > other) std::swap(one, other);
    enter = std::max(enter, one);
    leave = std::min(leave, other);
  }
  return enter <= leave;
}

}  // namespace glissade
