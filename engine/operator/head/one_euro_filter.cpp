#include "engine/operator/head/one_euro_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glissade {
namespace {

/// Delay in seconds of the low pass for the speed: a cut-off at 1 Hz, as in the authors' paper.
constexpr double kSpeedDelay = 1.0 / (2.0 * std::numbers::pi);
constexpr double kLeastDelay = 1e-4;

/// The share of a new value in a low pass of the first order that is behind by `delay` seconds.
double shareOf(double dt, double delay) { return dt / (dt + delay); }

}  // namespace

void OneEuroFilter::reset(double value) {
  smoothed_ = value;
  speed_ = 0.0;
}

double OneEuroFilter::smooth(double value, double dt) {
  speed_ += shareOf(dt, kSpeedDelay) * ((value - smoothed_) / dt - speed_);
  const double restCutoff = 1.0 / (2.0 * std::numbers::pi * std::max(shape_.restDelay, kLeastDelay));
  const double cutoff = restCutoff + shape_.speedUp * std::abs(speed_);
  delay_ = 1.0 / (2.0 * std::numbers::pi * cutoff);
  smoothed_ += shareOf(dt, delay_) * (value - smoothed_);
  return smoothed_;
}

}  // namespace glissade
