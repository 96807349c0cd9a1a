#pragma once

#include <cstddef>
#include <vector>

namespace glissade {

/// A share with the bounds of its 95 % confidence interval.
struct Proportion {
  double share = 0.0;
  double low = 0.0;
  double high = 1.0;
};

/// Successes among trials with Wilson's score interval (Wilson 1927), which is sound for few trials
/// and for shares of 0 and 1. No trials: share 0, interval 0 to 1.
Proportion wilson95(std::size_t successes, std::size_t trials);

/// Statistics of a sample.
struct Distribution {
  std::size_t count = 0;  ///< 0: the other members are undefined
  double minimum = 0.0;
  double firstQuartile = 0.0;
  double median = 0.0;
  double thirdQuartile = 0.0;
  double maximum = 0.0;
  double mean = 0.0;
};

/// Quartiles interpolate between order statistics (type 7 of Hyndman and Fan 1996: the default of R
/// and NumPy). The mean is summed in ascending order, so that the order given does not matter.
Distribution distributionOf(std::vector<double> sample);

}  // namespace glissade
