#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "engine/environment/forbidden_places.h"
#include "engine/planning/path.h"

namespace glissade::test {

/// The segment has a part of some length strictly inside of the box: clipped plane by plane (Liang and Barsky 1984).
inline bool entersBox(const Vector3& from, const Vector3& to, const Box3& box) {
  double first = 0.0;
  double last = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      // Inside: side * (p - bound) < 0.
      const double bound = side < 0.0 ? box.min()[axis] : box.max()[axis];
      const double outside = side * (from[axis] - bound);
      const double towards = side * (to[axis] - from[axis]);
      if (towards == 0.0 && outside >= 0.0) return false;
      if (towards > 0.0) last = std::min(last, -outside / towards);
      if (towards < 0.0) first = std::max(first, -outside / towards);
    }
  }
  return last - first > 1e-12;
}

/// The forbidden place that a path enters; empty: it keeps out of all.
inline std::string enteredBy(const std::vector<Pose>& path, const ForbiddenPlaces& places) {
  for (const ForbiddenPlace& place : places) {
    for (const Box3& box : place.boxes) {
      for (std::size_t i = 1; i < path.size(); ++i) {
        if (entersBox(path[i - 1].position, path[i].position, box)) return place.name;
      }
    }
  }
  return {};
}

}  // namespace glissade::test
