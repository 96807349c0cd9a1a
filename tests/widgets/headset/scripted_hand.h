// A hand of the scripted controllers that moves as somebody who sees the world.
#pragma once

#include "tests/widgets/headset/runtime/headset_script.h"
#include "widgets/headset/room_placement.h"

namespace glissade::test {

/// Adds up what the hand is to do; play() lets it begin.
class ScriptedHand {
 public:
  ScriptedHand(std::size_t hand, const RoomPlacement& room, const Pose& X_WG) : hand_(hand), room_(room) {
    moment_.X_RG = inRoom(X_WG);
    setController(hand_, moment_);
  }

  const Pose& X_WG() const { return X_WG_; }
  ScriptedHand& move(const Pose& X_WG, double seconds) {
    moment_.X_RG = inRoom(X_WG);
    return add(seconds);
  }
  ScriptedHand& squeeze(double share) {
    moment_.squeeze = share;
    return add(0.0);
  }
  /// And released.
  ScriptedHand& press(const char* component) {
    moment_.pressed = component;
    add(0.0);
    moment_.pressed.clear();
    return add(0.0);
  }
  ScriptedHand& loseTracking(bool isLost) {
    moment_.isTracked = !isLost;
    return add(0.0);
  }
  ScriptedHand& wait(double seconds) { return add(seconds); }
  void play() {
    playController(hand_, moments_);
    moments_.clear();
  }
  bool hasPlayed() const { return test::hasPlayed(hand_); }

 private:
  Pose inRoom(const Pose& X_WG) {
    X_WG_ = X_WG;
    const Pose X_RG = inverse(room_.X_WR) * X_WG;
    return {room_.scale * X_RG.position, X_RG.orientation};
  }
  ScriptedHand& add(double seconds) {
    moment_.after = seconds;
    moments_.push_back(moment_);
    return *this;
  }

  std::size_t hand_;
  RoomPlacement room_;
  Pose X_WG_;  ///< where it is in the end
  ControllerMoment moment_;
  std::vector<ControllerMoment> moments_;
};

}  // namespace glissade::test
