#pragma once

#include <algorithm>
#include <limits>

namespace glissade {

/// The range from the least to the greatest number taken; empty at first.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void take(const Range& other) {
    take(other.low);
    take(other.high);
  }
};

}  // namespace glissade
