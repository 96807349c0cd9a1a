#pragma once

#include <openxr/openxr.h>

#include <array>
#include <string>
#include <vector>

#include "widgets/openxr/controller_bindings.h"
#include "widgets/openxr/controller_state.h"
#include "widgets/openxr/headset_session.h"

namespace glissade {

/// The actions of OpenXR by which the controllers of a session are read. Used on the thread of the session, and
/// destroyed before it. Functions throw HeadsetFailure; a refused call of read() and pulse() has no effect.
class ControllerActions {
 public:
  ControllerActions(const HeadsetRuntime& runtime, HeadsetSession& session);
  ~ControllerActions();
  ControllerActions(const ControllerActions&) = delete;
  ControllerActions& operator=(const ControllerActions&) = delete;

  /// The poses of the controllers at this time, and the present state of their components. Both are empty while another
  /// program has the controllers.
  BothControllers read(XrTime time);
  /// Vibrates the controller until the next picture; strength in [0, 1] of the strongest.
  void pulse(ControllerSide side, double strength);

 private:
  /// The spaces and the profile of one hand.
  struct Hand {
    XrPath path = XR_NULL_PATH;
    XrSpace grip = XR_NULL_HANDLE;
    XrSpace aim = XR_NULL_HANDLE;
    XrPath profile = XR_NULL_PATH;
    std::string name;  ///< name of the profile
  };

  void make();
  void destroy();
  void makeAction(ControllerAction action, const char* name, XrActionType type);
  void suggest(const ControllerProfile& profile);
  void attach();
  XrSpace makeSpace(ControllerAction action, const Hand& hand);
  XrPath pathOf(const std::string& text) const;
  std::string textOf(XrPath path) const;
  XrAction handleOf(ControllerAction action) const { return actions_[static_cast<std::size_t>(action)]; }
  XrActionStateGetInfo question(ControllerAction action, const Hand& hand) const;

  ControllerState readHand(Hand& hand, XrTime time);
  void readName(Hand& hand);
  std::optional<Pose> locate(ControllerAction action, const Hand& hand, XrSpace space, XrTime time) const;
  double share(ControllerAction action, const Hand& hand) const;
  bool isDown(ControllerAction action, const Hand& hand) const;
  Eigen::Vector2d stick(const Hand& hand) const;

  const HeadsetRuntime& runtime_;
  HeadsetSession& session_;
  XrActionSet set_ = XR_NULL_HANDLE;
  std::array<XrAction, kControllerActions> actions_{};
  std::array<Hand, 2> hands_;
};

}  // namespace glissade
