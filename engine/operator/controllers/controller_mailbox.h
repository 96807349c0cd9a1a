#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "engine/base/mailbox.h"
#include "engine/geometry/pose.h"

namespace glissade {

/// What a tracked controller last said, in the world W.
struct ControllerReading {
  std::optional<Pose> X_WG;  ///< grip G: the middle of the closed hand; nothing while it is not tracked
  std::optional<Pose> X_WA;  ///< aim A: it points along -z; nothing while it is not tracked
  double squeeze = 0.0;      ///< of the grip, in [0, 1]
  double scale = 1.0;        ///< metres of the room of the hand for each metre of the world
  unsigned held = 0;         ///< buttons that are down: bit n is ControllerButton n
};

/// What a hand does with the object, and feels of it.
struct ControllerFeedback {
  bool holds = false;                ///< the object
  double push = 0.0;                 ///< how strongly obstacles push it back, as a share of the strongest, in [0, 1]
  std::optional<double> pointsAt{};  ///< metres along the aim to the object; nothing: it points elsewhere
};

/// Between the headset, which tracks a controller, and whoever uses it: the latest wins, both ways. All functions may
/// be called on any thread and return at once.
class ControllerMailbox {
 public:
  using Clock = std::chrono::steady_clock;

  /// A controller counts as lost when nothing was heard for `silence`; nothing: the last reading holds.
  explicit ControllerMailbox(std::optional<std::chrono::milliseconds> silence) : silence_(silence) {}

  /// Poses that are not valid count as not tracked.
  void set(const ControllerReading& reading);
  /// Without poses and buttons where the controller is lost; the hand is as it was heard last.
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
