#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "engine/base/mailbox.h"
#include "engine/geometry/pose.h"

namespace glissade {

/// The latest state of a tracked controller, in the world W.
struct ControllerReading {
  std::optional<Pose> X_WG;  ///< pose of the grip G, the middle of the closed hand; nothing while it is not tracked
  std::optional<Pose> X_WA;  ///< pose of the aim A, which points along -z; nothing while it is not tracked
  double squeeze = 0.0;      ///< squeeze of the grip, in [0, 1]
  double scale = 1.0;        ///< metres of the hand's motion in the room for each metre of the world
  unsigned held = 0;         ///< pressed buttons: bit n is ControllerButton n
};

/// State of a hand with respect to the object, and its contact force.
struct ControllerFeedback {
  bool holds = false;                ///< the hand holds the object
  double push = 0.0;                 ///< strength of the obstacles' force, as a share of the maximum, in [0, 1]
  std::optional<double> pointsAt{};  ///< distance along the aim to the object, metres; nothing: it points elsewhere
};

/// Passes data between the headset, which tracks a controller, and its users. The latest data count in both directions.
/// All functions may be called on any thread and return at once.
class ControllerMailbox {
 public:
  using Clock = std::chrono::steady_clock;

  /// A controller counts as lost after `silence` without data; nothing: the last reading holds.
  explicit ControllerMailbox(std::optional<std::chrono::milliseconds> silence) : silence_(silence) {}

  /// Poses that are not valid count as not tracked.
  void set(const ControllerReading& reading);
  /// The latest reading. Without poses and buttons where the controller is lost; the hand is the last one received.
  ControllerReading reading() const;

  void setFeedback(const ControllerFeedback& feedback);
  ControllerFeedback feedback() const { return feedback_.get(); }

  /// Called after every set(), on the thread that made it; must return at once. After setListener({}) has returned no
  /// call is under way.
  void setListener(std::function<void()> listener) { heard_.setListener(std::move(listener)); }

 private:
  struct Heard {
    ControllerReading reading;
    Clock::time_point at;
  };

  const std::optional<std::chrono::milliseconds> silence_;
  Mailbox<Heard> heard_;
  Mailbox<ControllerFeedback> feedback_;
};

}  // namespace glissade
