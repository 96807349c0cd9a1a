#pragma once

#include <algorithm>

namespace glissade {

/// What marks about the object are measured by: they follow the object, and never fill the view.
struct MarkScale {
  double objectRadius = 0.0;  ///< metres
  double viewHeight = 0.0;    ///< metres that the view shows at the depth of its focus

  /// So many radii of the object, at most this share of the view; metres.
  double length(double radii, double mostOfView) const {
    return std::min(radii * objectRadius, mostOfView * viewHeight);
  }
};

}  // namespace glissade
