// A person of the scripted controllers who carries the panel in the left hand and points at it with the right one.
#pragma once

#include "engine/geometry/least_rotation.h"
#include "tests/widgets/headset/runtime/headset_script.h"
#include "widgets/headset/panel_in_room.h"

namespace glissade::test {

class PointingHands {
 public:
  /// The left hand is there; the right one comes with the first motion.
  explicit PointingHands(const Pose& X_RG) {
    ControllerMoment left;
    left.X_RG = X_RG;
    setController(0, left);
    BothControllers hands;
    hands[0].X_RG = X_RG;
    PanelInRoom panel;
    panel.advance(hands, {});
    X_RP_ = *panel.X_RP();
  }

  /// `at`: shares of the panel's width and height, from its upper left corner.
  PointingHands& pointAt(const Eigen::Vector2d& at) {
    const Vector3 p_P((at.x() - 0.5) * PanelInRoom::kWidth, (0.5 - at.y()) * PanelInRoom::kHeight, 0.0);
    const Vector3 target = X_RP_ * p_P;
    const Vector3 from = X_RP_ * Vector3(0.2, -0.1, 0.3);
    right_.X_RG = {from, leastRotation(-Vector3::UnitZ(), target - from)};
    return add();
  }
  PointingHands& pull() {
    right_.trigger = 1.0;
    return add();
  }
  PointingHands& release() {
    right_.trigger = 0.0;
    return add();
  }
  void play() {
    if (!isThere_) setController(1, moments_.front());
    isThere_ = true;
    playController(1, moments_);
    moments_.clear();
  }

 private:
  PointingHands& add() {
    right_.after = 0.0;
    moments_.push_back(right_);
    return *this;
  }

  Pose X_RP_;
  ControllerMoment right_;
  bool isThere_ = false;
  std::vector<ControllerMoment> moments_;
};

}  // namespace glissade::test
