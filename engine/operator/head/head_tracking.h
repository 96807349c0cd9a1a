#pragma once

#include <array>
#include <optional>

#include "engine/geometry/pose.h"
#include "engine/operator/head/one_euro_filter.h"
#include "engine/operator/head/opentrack_protocol.h"

namespace glissade {

/// From which number of the tracker one of the head's comes, and with which sign.
struct HeadAxis {
  int source = 0;  ///< index into HeadReading
  bool inverted = false;

  friend bool operator==(const HeadAxis&, const HeadAxis&) = default;
};

/// How the numbers of a tracker become the motion of a head.
struct HeadShaping {
  /// Right, up, towards the person; yaw to the left, pitch upwards, roll to the left.
  std::array<HeadAxis, 6> axes{{{0}, {1}, {2}, {3}, {4}, {5}}};
  /// What the tracker says while the person sits straight before the screen, looking at it.
  HeadReading rest{};
  double restDelay = 0.08;  ///< seconds that the smoothed motion is behind at rest

  friend bool operator==(const HeadShaping&, const HeadShaping&) = default;
};

inline constexpr double kMostRestDelay = 0.5;

/// Sources that exist, numbers that are finite, a delay in its range: what does not hold becomes the standard.
HeadShaping inRange(const HeadShaping& shaping);

/// What the head has done since it sat straight before the screen.
struct HeadMotion {
  Vector3 shift = Vector3::Zero();  ///< metres: right, up, towards the person
  Quaternion turn = Quaternion::Identity();
};

/// Follows a head by what a tracker says of it, smoothed. Where the tracker falls silent, the motion returns to
/// rest slowly. Times are seconds of any clock that does not go back.
class HeadTracking {
 public:
  /// Seconds of silence after which the head is lost.
  static constexpr double kSilence = 0.5;
  /// Seconds in which a lost head returns by all but a third of its way.
  static constexpr double kReturn = 0.8;

  void setShaping(const HeadShaping& shaping);
  const HeadShaping& shaping() const { return shaping_; }
  /// What the tracker says now is what it says at rest.
  void restHere();

  void take(const HeadReading& reading, double time);
  /// Moves a lost head on its way back; does nothing to a head that is tracked.
  void passTime(double time);

  /// Something came within kSilence.
  bool isTracked(double time) const { return heard_ && time - *heard_ <= kSilence; }
  /// Nothing moves before the next reading.
  bool isAtRest() const;
  HeadMotion motion() const;
  /// What came last; zeros before.
  const HeadReading& last() const { return last_; }
  /// Seconds that the motion across the screen is behind, as it is now.
  double delay() const { return filters_[0].delay(); }

 private:
  std::array<double, 6> shaped(const HeadReading& reading) const;

  HeadShaping shaping_;
  std::array<OneEuroFilter, 6> filters_;
  std::array<double, 6> now_{};
  HeadReading last_{};
  std::optional<double> heard_;  ///< the time of the last reading
  double passed_ = 0.0;          ///< the time up to which the way back has been gone
};

}  // namespace glissade
