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
  bool pressed = false;                          ///< whether the trigger is pressed

  friend bool operator==(const PanelPointer& a, const PanelPointer& b) {
    return a.at == b.at && a.pressed == b.pressed;
  }
};

/// Passes the pointing of a hand at the panel from the thread of the headset to the window, as a sequence of moments.
/// No press and no release is lost; of successive motions only the latest is kept. All functions may be called on any
/// thread and return at once.
class PointerMailbox {
 public:
  using Moment = std::optional<PanelPointer>;  ///< nothing: no hand points at the panel

  void set(const Moment& now);
  /// The moments since the last take().
  std::vector<Moment> take();
  /// Sets a function that is called after a set() with a new value, on the thread of that set(); it must return at
  /// once. After setListener({}) has returned no call is under way.
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
