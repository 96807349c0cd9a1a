#pragma once

#include <array>
#include <optional>

#include "engine/geometry/pose.h"
#include "engine/operator/head/one_euro_filter.h"
#include "engine/operator/head/opentrack_protocol.h"

namespace glissade {

/// The tracker's number for one axis of the head, with its sign.
struct HeadAxis {
  int source = 0;  ///< index into HeadReading
  bool inverted = false;

  friend bool operator==(const HeadAxis&, const HeadAxis&) = default;
};

/// Mapping of a tracker's numbers to the motion of a head.
struct HeadShaping {
  /// Axes: right, up, towards the person; yaw to the left, pitch upwards, roll to the left.
  std::array<HeadAxis, 6> axes{{{0}, {1}, {2}, {3}, {4}, {5}}};
  /// The tracker's reading while the person sits straight before the screen, looking at it.
  HeadReading rest{};
  double restDelay = 0.08;  ///< delay of the smoothed motion at rest, seconds

  friend bool operator==(const HeadShaping&, const HeadShaping&) = default;
};

inline constexpr double kMostRestDelay = 0.5;

/// The shaping with existing sources, finite numbers and a delay in its range; other values become the default.
HeadShaping inRange(const HeadShaping& shaping);

/// Motion of the head from its rest before the screen.
struct HeadMotion {
  Vector3 shift = Vector3::Zero();  ///< translation right, up, and towards the person, metres
  Quaternion turn = Quaternion::Identity();
};

/// Follows a head by a tracker's readings, with smoothing. When the tracker falls silent, the motion returns to rest
/// slowly. Times are seconds of any clock that does not go back.
class HeadTracking {
 public:
  /// Seconds of silence after which the head is lost.
  static constexpr double kSilence = 0.5;
  /// Time constant of the return of a lost head, seconds: after it a third of the deviation is left.
  static constexpr double kReturn = 0.8;

  void setShaping(const HeadShaping& shaping);
  const HeadShaping& shaping() const { return shaping_; }
  /// Makes the present reading the one at rest.
  void restHere();

  void take(const HeadReading& reading, double time);
  /// Moves a lost head towards rest; does nothing to a tracked head.
  void passTime(double time);

  /// True if a reading came within kSilence.
  bool isTracked(double time) const { return heard_ && time - *heard_ <= kSilence; }
  /// True if nothing moves before the next reading.
  bool isAtRest() const;
  HeadMotion motion() const;
  /// The last reading; zeros before the first.
  const HeadReading& last() const { return last_; }
  /// Present delay of the motion across the screen, seconds.
  double delay() const { return filters_[0].delay(); }

 private:
  std::array<double, 6> shaped(const HeadReading& reading) const;

  HeadShaping shaping_;
  std::array<OneEuroFilter, 6> filters_;
  std::array<double, 6> now_{};
  HeadReading last_{};
  std::optional<double> heard_;  ///< time of the last reading
  double passed_ = 0.0;          ///< time up to which the return was computed
};

}  // namespace glissade
