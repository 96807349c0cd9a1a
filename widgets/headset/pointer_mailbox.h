#pragma once

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

#include "engine/base/mailbox.h"

namespace glissade {

/// A hand that points at the panel.
struct PanelPointer {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< shares of width and height, from the upper left corner
  bool pressed = false;                          ///< the trigger

  friend bool operator==(const PanelPointer& a, const PanelPointer& b) {
    return a.at == b.at && a.pressed == b.pressed;
  }
};

/// Between the thread of the headset and the window: what a hand does at the panel, one moment after the other. No
/// press and no release is lost; of motions between them the latest is left. All functions may be called on any thread
/// and return at once.
class PointerMailbox {
 public:
  using Moment = std::optional<PanelPointer>;  ///< nothing: no hand points at the panel

  void set(const Moment& now);
  /// What has happened since it was asked last.
  std::vector<Moment> take();
  /// Called after a set() that says something new, on the thread that made it; must return at once. After
  /// setListener({}) has returned no call is under way.
  void setListener(std::function<void()> listener) { heard_.setListener(std::move(listener)); }

 private:
  struct Heard {
    Moment last;
    std::vector<Moment> moments;
  };
  static bool add(const Moment& now, Heard& heard);

  Mailbox<Heard> heard_;
};

}  // namespace glissade
