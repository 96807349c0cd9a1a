#include "engine/operator/head/head_tracking.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

/// Increase of the filter's cut-off, Hz per m/s and Hz per rad/s.
constexpr double kSpeedUpOfShifts = 20.0;
constexpr double kSpeedUpOfTurns = 4.0;
/// Largest deviation that counts as rest, metres and radians.
constexpr double kAtRest = 1e-4;
/// Least time between two readings, seconds, because a clock may not have advanced.
constexpr double kLeastStep = 1e-4;

}  // namespace

HeadShaping inRange(const HeadShaping& shaping) {
  HeadShaping kept = shaping;
  const HeadShaping standard;
  for (std::size_t i = 0; i < kept.axes.size(); ++i) {
    const int source = kept.axes[i].source;
    if (source < 0 || source >= static_cast<int>(kept.axes.size())) kept.axes[i] = standard.axes[i];
    if (!std::isfinite(kept.rest[i])) kept.rest[i] = 0.0;
  }
  if (!(kept.restDelay >= 0.0 && kept.restDelay <= kMostRestDelay)) kept.restDelay = standard.restDelay;
  return kept;
}

void HeadTracking::setShaping(const HeadShaping& shaping) {
  shaping_ = inRange(shaping);
  for (std::size_t i = 0; i < filters_.size(); ++i) {
    filters_[i].setShape({shaping_.restDelay, i < 3 ? kSpeedUpOfShifts : kSpeedUpOfTurns});
  }
}

void HeadTracking::restHere() {
  HeadShaping shaping = shaping_;
  shaping.rest = last_;
  setShaping(shaping);
}

std::array<double, 6> HeadTracking::shaped(const HeadReading& reading) const {
  std::array<double, 6> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto source = static_cast<std::size_t>(shaping_.axes[i].source);
    values[i] = (shaping_.axes[i].inverted ? -1.0 : 1.0) * (reading[source] - shaping_.rest[source]);
  }
  return values;
}

void HeadTracking::take(const HeadReading& reading, double time) {
  // After a silence the motion continues from the present pose of its return.
  const bool goesOn = isTracked(time);
  const double dt = goesOn ? std::max(time - *heard_, kLeastStep) : kSilence;
  const std::array<double, 6> values = shaped(reading);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!goesOn) filters_[i].reset(now_[i]);
    now_[i] = filters_[i].smooth(values[i], goesOn ? dt : kLeastStep);
  }
  last_ = reading;
  heard_ = time;
  passed_ = time;
}

void HeadTracking::passTime(double time) {
  if (!heard_ || isTracked(time)) return;
  const double since = std::max(passed_, *heard_ + kSilence);
  const double share = std::exp(-std::max(0.0, time - since) / kReturn);
  for (double& value : now_) {
    value *= share;
    if (std::abs(value) < kAtRest) value = 0.0;
  }
  passed_ = time;
}

bool HeadTracking::isAtRest() const {
  return std::all_of(now_.begin(), now_.end(), [](double value) { return value == 0.0; });
}

HeadMotion HeadTracking::motion() const {
  const Eigen::AngleAxisd yaw(now_[3], Vector3::UnitY());
  const Eigen::AngleAxisd pitch(now_[4], Vector3::UnitX());
  const Eigen::AngleAxisd roll(now_[5], Vector3::UnitZ());
  return {Vector3(now_[0], now_[1], now_[2]), Quaternion(yaw * pitch * roll)};
}

}  // namespace glissade
