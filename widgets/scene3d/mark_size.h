#pragma once

#include <algorithm>

namespace glissade {

/// The lengths that determine the size of marks about the object: marks follow the object, and never fill the view.
struct MarkScale {
  double objectRadius = 0.0;  ///< metres
  double viewHeight = 0.0;    ///< height of the view at the focus, metres

  /// This number of radii of the object, at most this share of the view; metres.
  double length(double radii, double mostOfView) const {
    return std::min(radii * objectRadius, mostOfView * viewHeight);
  }
};

}  // namespace glissade
