#include "widgets/openxr/controller_actions.h"

#include <cstring>

#include "widgets/openxr/headset_failure.h"
#include "widgets/openxr/xr_pose.h"

namespace glissade {
namespace {

constexpr std::array kHandPaths{"/user/hand/left", "/user/hand/right"};
constexpr const char* kProfiles = "/interaction_profiles/";
/// Duration of a pulse in nanoseconds. It is longer than a picture, so that a push is felt without gaps.
constexpr XrDuration kPulse = 30'000'000;

void copyName(char* target, std::size_t size, const char* name) { std::strncpy(target, name, size - 1); }

}  // namespace

ControllerActions::ControllerActions(const HeadsetRuntime& runtime, HeadsetSession& session)
    : runtime_(runtime), session_(session) {
  XrActionSetCreateInfo info{};
  info.type = XR_TYPE_ACTION_SET_CREATE_INFO;
  copyName(info.actionSetName, sizeof info.actionSetName, "hands");
  copyName(info.localizedActionSetName, sizeof info.localizedActionSetName, "Hands");
  checkXr(xrCreateActionSet(runtime_.instance(), &info, &set_), "xrCreateActionSet");
  try {
    make();
  } catch (const HeadsetFailure&) {
    destroy();
    throw;
  }
}

ControllerActions::~ControllerActions() { destroy(); }

/// Destroys the spaces and the set, and with the set its actions.
void ControllerActions::destroy() {
  for (const Hand& hand : hands_) {
    for (XrSpace space : {hand.grip, hand.aim}) {
      if (space != XR_NULL_HANDLE) xrDestroySpace(space);
    }
  }
  xrDestroyActionSet(set_);
}

void ControllerActions::make() {
  for (std::size_t i = 0; i < hands_.size(); ++i) hands_[i].path = pathOf(kHandPaths[i]);
  makeAction(ControllerAction::Grip, "grip", XR_ACTION_TYPE_POSE_INPUT);
  makeAction(ControllerAction::Aim, "aim", XR_ACTION_TYPE_POSE_INPUT);
  makeAction(ControllerAction::Squeeze, "squeeze", XR_ACTION_TYPE_FLOAT_INPUT);
  makeAction(ControllerAction::Trigger, "trigger", XR_ACTION_TYPE_FLOAT_INPUT);
  makeAction(ControllerAction::Stick, "stick", XR_ACTION_TYPE_VECTOR2F_INPUT);
  makeAction(ControllerAction::Menu, "menu", XR_ACTION_TYPE_BOOLEAN_INPUT);
  makeAction(ControllerAction::Lower, "lower_button", XR_ACTION_TYPE_BOOLEAN_INPUT);
  makeAction(ControllerAction::Upper, "upper_button", XR_ACTION_TYPE_BOOLEAN_INPUT);
  makeAction(ControllerAction::StickClick, "stick_click", XR_ACTION_TYPE_BOOLEAN_INPUT);
  makeAction(ControllerAction::Pulse, "pulse", XR_ACTION_TYPE_VIBRATION_OUTPUT);
  for (const ControllerProfile& profile : controllerProfiles()) suggest(profile);
  attach();
  for (Hand& hand : hands_) {
    hand.grip = makeSpace(ControllerAction::Grip, hand);
    hand.aim = makeSpace(ControllerAction::Aim, hand);
  }
}

void ControllerActions::makeAction(ControllerAction action, const char* name, XrActionType type) {
  const std::array paths{hands_[0].path, hands_[1].path};
  XrActionCreateInfo info{};
  info.type = XR_TYPE_ACTION_CREATE_INFO;
  info.actionType = type;
  info.countSubactionPaths = static_cast<std::uint32_t>(paths.size());
  info.subactionPaths = paths.data();
  copyName(info.actionName, sizeof info.actionName, name);
  copyName(info.localizedActionName, sizeof info.localizedActionName, name);
  checkXr(xrCreateAction(set_, &info, &actions_[static_cast<std::size_t>(action)]), "xrCreateAction");
}

/// Suggests bindings of a profile, which the runtime need not know.
void ControllerActions::suggest(const ControllerProfile& profile) {
  std::vector<XrActionSuggestedBinding> bindings;
  for (const ControllerBinding& binding : profile.bindings) {
    const auto side = static_cast<std::size_t>(binding.side);
    bindings.push_back({handleOf(binding.action), pathOf(std::string(kHandPaths[side]) + binding.component)});
  }
  XrInteractionProfileSuggestedBinding info{};
  info.type = XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING;
  info.interactionProfile = pathOf(profile.path);
  info.countSuggestedBindings = static_cast<std::uint32_t>(bindings.size());
  info.suggestedBindings = bindings.data();
  const XrResult result = xrSuggestInteractionProfileBindings(runtime_.instance(), &info);
  if (result != XR_ERROR_PATH_UNSUPPORTED) checkXr(result, "xrSuggestInteractionProfileBindings");
}

void ControllerActions::attach() {
  XrSessionActionSetsAttachInfo info{};
  info.type = XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO;
  info.countActionSets = 1;
  info.actionSets = &set_;
  checkXr(xrAttachSessionActionSets(session_.handle(), &info), "xrAttachSessionActionSets");
}

XrSpace ControllerActions::makeSpace(ControllerAction action, const Hand& hand) {
  XrActionSpaceCreateInfo info{};
  info.type = XR_TYPE_ACTION_SPACE_CREATE_INFO;
  info.action = handleOf(action);
  info.subactionPath = hand.path;
  info.poseInActionSpace.orientation.w = 1.0F;
  XrSpace space = XR_NULL_HANDLE;
  checkXr(xrCreateActionSpace(session_.handle(), &info, &space), "xrCreateActionSpace");
  return space;
}

XrPath ControllerActions::pathOf(const std::string& text) const {
  XrPath path = XR_NULL_PATH;
  checkXr(xrStringToPath(runtime_.instance(), text.c_str(), &path), "xrStringToPath");
  return path;
}

std::string ControllerActions::textOf(XrPath path) const {
  std::array<char, XR_MAX_PATH_LENGTH> text{};
  std::uint32_t length = 0;
  checkXr(xrPathToString(runtime_.instance(), path, static_cast<std::uint32_t>(text.size()), &length, text.data()),
          "xrPathToString");
  return text.data();
}

BothControllers ControllerActions::read(XrTime time) {
  const XrActiveActionSet active{set_, XR_NULL_PATH};
  XrActionsSyncInfo info{};
  info.type = XR_TYPE_ACTIONS_SYNC_INFO;
  info.countActiveActionSets = 1;
  info.activeActionSets = &active;
  const XrResult result = xrSyncActions(session_.handle(), &info);
  if (!session_.refused().accept(result, "xrSyncActions") || result == XR_SESSION_NOT_FOCUSED) return {};
  return {readHand(hands_[0], time), readHand(hands_[1], time)};
}

ControllerState ControllerActions::readHand(Hand& hand, XrTime time) {
  readName(hand);
  ControllerState state;
  state.name = hand.name;
  state.X_RG = locate(ControllerAction::Grip, hand, hand.grip, time);
  state.X_RA = locate(ControllerAction::Aim, hand, hand.aim, time);
  state.squeeze = share(ControllerAction::Squeeze, hand);
  state.trigger = share(ControllerAction::Trigger, hand);
  state.stick = stick(hand);
  const auto read = [&](ControllerButton button, ControllerAction action) {
    state.pressed[static_cast<std::size_t>(button)] = isDown(action, hand);
  };
  read(ControllerButton::Menu, ControllerAction::Menu);
  read(ControllerButton::Lower, ControllerAction::Lower);
  read(ControllerButton::Upper, ControllerAction::Upper);
  read(ControllerButton::Stick, ControllerAction::StickClick);
  return state;
}

void ControllerActions::readName(Hand& hand) {
  XrInteractionProfileState state{};
  state.type = XR_TYPE_INTERACTION_PROFILE_STATE;
  const XrResult result = xrGetCurrentInteractionProfile(session_.handle(), hand.path, &state);
  if (!session_.refused().accept(result, "xrGetCurrentInteractionProfile")) return;
  if (state.interactionProfile == hand.profile) return;
  hand.profile = state.interactionProfile;
  hand.name.clear();
  if (hand.profile != XR_NULL_PATH) hand.name = textOf(hand.profile).substr(std::strlen(kProfiles));
}

XrActionStateGetInfo ControllerActions::question(ControllerAction action, const Hand& hand) const {
  XrActionStateGetInfo info{};
  info.type = XR_TYPE_ACTION_STATE_GET_INFO;
  info.action = handleOf(action);
  info.subactionPath = hand.path;
  return info;
}

/// The pose of a space; nothing if the runtime does not track it but guesses.
std::optional<Pose> ControllerActions::locate(ControllerAction action, const Hand& hand, XrSpace space,
                                              XrTime time) const {
  const XrActionStateGetInfo info = question(action, hand);
  XrActionStatePose state{};
  state.type = XR_TYPE_ACTION_STATE_POSE;
  RefusedCalls& refused = session_.refused();
  if (!refused.accept(xrGetActionStatePose(session_.handle(), &info, &state), "xrGetActionStatePose") ||
      state.isActive == XR_FALSE) {
    return std::nullopt;
  }
  XrSpaceLocation location{};
  location.type = XR_TYPE_SPACE_LOCATION;
  if (!refused.accept(xrLocateSpace(space, session_.room(), time, &location), "xrLocateSpace")) return std::nullopt;
  constexpr XrSpaceLocationFlags kTracked =
      XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT |
      XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
  return (location.locationFlags & kTracked) == kTracked ? std::optional(poseOf(location.pose)) : std::nullopt;
}

double ControllerActions::share(ControllerAction action, const Hand& hand) const {
  const XrActionStateGetInfo info = question(action, hand);
  XrActionStateFloat state{};
  state.type = XR_TYPE_ACTION_STATE_FLOAT;
  session_.refused().accept(xrGetActionStateFloat(session_.handle(), &info, &state), "xrGetActionStateFloat");
  return state.isActive == XR_TRUE ? static_cast<double>(state.currentState) : 0.0;
}

bool ControllerActions::isDown(ControllerAction action, const Hand& hand) const {
  const XrActionStateGetInfo info = question(action, hand);
  XrActionStateBoolean state{};
  state.type = XR_TYPE_ACTION_STATE_BOOLEAN;
  session_.refused().accept(xrGetActionStateBoolean(session_.handle(), &info, &state), "xrGetActionStateBoolean");
  return state.isActive == XR_TRUE && state.currentState == XR_TRUE;
}

Eigen::Vector2d ControllerActions::stick(const Hand& hand) const {
  const XrActionStateGetInfo info = question(ControllerAction::Stick, hand);
  XrActionStateVector2f state{};
  state.type = XR_TYPE_ACTION_STATE_VECTOR2F;
  session_.refused().accept(xrGetActionStateVector2f(session_.handle(), &info, &state), "xrGetActionStateVector2f");
  if (state.isActive == XR_FALSE) return Eigen::Vector2d::Zero();
  return {state.currentState.x, state.currentState.y};
}

void ControllerActions::pulse(ControllerSide side, double strength) {
  XrHapticActionInfo info{};
  info.type = XR_TYPE_HAPTIC_ACTION_INFO;
  info.action = handleOf(ControllerAction::Pulse);
  info.subactionPath = hands_[static_cast<std::size_t>(side)].path;
  XrHapticVibration vibration{};
  vibration.type = XR_TYPE_HAPTIC_VIBRATION;
  vibration.duration = kPulse;
  vibration.frequency = XR_FREQUENCY_UNSPECIFIED;
  vibration.amplitude = static_cast<float>(strength);
  const auto* feedback = reinterpret_cast<const XrHapticBaseHeader*>(&vibration);
  session_.refused().accept(xrApplyHapticFeedback(session_.handle(), &info, feedback), "xrApplyHapticFeedback");
}

}  // namespace glissade
