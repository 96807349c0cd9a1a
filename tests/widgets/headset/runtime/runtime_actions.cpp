// Actions of the runtime for tests, with controllers that the script moves.
#include <algorithm>
#include <cstring>
#include <utility>

#include "tests/widgets/headset/runtime/runtime_state.h"
#include "tests/widgets/headset/runtime/xr_values.h"

namespace glissade::test {
namespace {

using Lock = std::lock_guard<std::mutex>;

constexpr std::array kHands{"/user/hand/left", "/user/hand/right"};
/// The components of a controller to which the program may bind actions, as the profile names them.
constexpr const char* kComponents[] = {"/input/grip/pose",        "/input/aim/pose",   "/input/squeeze/value",
                                       "/input/trigger/value",    "/input/thumbstick", "/input/menu/click",
                                       "/input/thumbstick/click", "/input/x/click",    "/input/y/click",
                                       "/input/a/click",          "/input/b/click",    "/output/haptic"};

std::string textOf(const RuntimeState& state, XrPath path) {
  return path == XR_NULL_PATH || path > state.paths.size() ? std::string() : state.paths[path - 1];
}

FakeAction& actionOf(RuntimeState& state, XrAction action) {
  return state.actions.at(reinterpret_cast<std::uint64_t>(action));
}

/// The component of this hand to which an action is bound; empty if there is none.
std::string componentOf(RuntimeState& state, XrAction action, XrPath hand) {
  const auto& bound = actionOf(state, action).bound;
  const auto found = bound.find(textOf(state, hand));
  return found == bound.end() ? std::string() : found->second;
}

const ControllerMoment& momentOf(const RuntimeState& state, XrPath hand) {
  return state.controllers[textOf(state, hand) == kHands[0] ? 0 : 1].shown;
}

XRAPI_ATTR XrResult XRAPI_CALL stringToPath(XrInstance /*instance*/, const char* text, XrPath* path) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  auto found = std::find(state.paths.begin(), state.paths.end(), text);
  if (found == state.paths.end()) found = state.paths.insert(found, text);
  *path = static_cast<XrPath>(found - state.paths.begin()) + 1;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL pathToString(XrInstance /*instance*/, XrPath path, std::uint32_t capacity,
                                            std::uint32_t* count, char* buffer) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  const std::string text = textOf(state, path);
  *count = static_cast<std::uint32_t>(text.size() + 1);
  if (capacity >= *count) std::strcpy(buffer, text.c_str());
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL createActionSet(XrInstance /*instance*/, const XrActionSetCreateInfo* /*info*/,
                                               XrActionSet* set) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = instanceResult(state); result != XR_SUCCESS) return result;
  ++state.actionSets;
  *set = newHandle<XrActionSet>(state);
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL destroyActionSet(XrActionSet /*set*/) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  --state.actionSets;
  state.actions.clear();
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL createAction(XrActionSet /*set*/, const XrActionCreateInfo* info, XrAction* action) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = instanceResult(state); result != XR_SUCCESS) return result;
  *action = newHandle<XrAction>(state);
  state.actions[reinterpret_cast<std::uint64_t>(*action)] = {info->actionType, {}};
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL destroyAction(XrAction action) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  state.actions.erase(reinterpret_cast<std::uint64_t>(action));
  return XR_SUCCESS;
}

/// Takes the bindings of the profile that the scripted controllers have, and ignores those of other profiles.
XRAPI_ATTR XrResult XRAPI_CALL suggestBindings(XrInstance /*instance*/,
                                               const XrInteractionProfileSuggestedBinding* info) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = instanceResult(state); result != XR_SUCCESS) return result;
  if (textOf(state, info->interactionProfile) != kScriptedProfile) return XR_SUCCESS;
  for (std::uint32_t i = 0; i < info->countSuggestedBindings; ++i) {
    const XrActionSuggestedBinding& binding = info->suggestedBindings[i];
    const std::string path = textOf(state, binding.binding);
    const std::size_t end = path.find('/', std::strlen("/user/hand/"));
    const std::string component = path.substr(std::min(end, path.size()));
    if (std::find(std::begin(kComponents), std::end(kComponents), component) == std::end(kComponents)) {
      return XR_ERROR_PATH_UNSUPPORTED;
    }
    actionOf(state, binding.action).bound[path.substr(0, end)] = component;
  }
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL attachActionSets(XrSession /*session*/, const XrSessionActionSetsAttachInfo* /*info*/) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = sessionResult(state); result != XR_SUCCESS) return result;
  if (std::exchange(state.attached, true)) return XR_ERROR_ACTIONSETS_ALREADY_ATTACHED;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL currentProfile(XrSession session, XrPath hand, XrInteractionProfileState* profile) {
  bool isThere = false;
  {
    RuntimeState& state = runtimeState();
    const Lock lock(state.mutex);
    if (const XrResult result = callResult(state); result != XR_SUCCESS) return result;
    if (!state.attached) return XR_ERROR_ACTIONSET_NOT_ATTACHED;
    isThere = momentOf(state, hand).isThere;
  }
  profile->interactionProfile = XR_NULL_PATH;
  return isThere ? stringToPath(std::bit_cast<XrInstance>(session), kScriptedProfile, &profile->interactionProfile)
                 : XR_SUCCESS;
}

/// The controllers take the state that the script has at the time of this call.
XRAPI_ATTR XrResult XRAPI_CALL syncActions(XrSession /*session*/, const XrActionsSyncInfo* /*info*/) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = callResult(state); result != XR_SUCCESS) return result;
  if (!state.attached) return XR_ERROR_ACTIONSET_NOT_ATTACHED;
  if (state.sessionState != XR_SESSION_STATE_FOCUSED) return XR_SESSION_NOT_FOCUSED;
  ++state.syncs;
  const auto now = std::chrono::steady_clock::now();
  for (FakeController& controller : state.controllers) controller.advanceTo(now);
  state.changed.notify_all();
  return XR_SUCCESS;
}

/// Calls give(component, moment) if the action is bound for the hand and the controller is connected.
template <class State, class Give>
XrResult giveState(const XrActionStateGetInfo* info, XrActionType type, State* answer, Give give) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = sessionResult(state); result != XR_SUCCESS) return result;
  if (actionOf(state, info->action).type != type) return XR_ERROR_ACTION_TYPE_MISMATCH;
  const ControllerMoment& moment = momentOf(state, info->subactionPath);
  const std::string component = componentOf(state, info->action, info->subactionPath);
  answer->isActive = !component.empty() && moment.isThere ? XR_TRUE : XR_FALSE;
  if (answer->isActive == XR_TRUE) give(component, moment);
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL stateFloat(XrSession /*session*/, const XrActionStateGetInfo* info,
                                          XrActionStateFloat* answer) {
  answer->currentState = 0.0F;
  return giveState(info, XR_ACTION_TYPE_FLOAT_INPUT, answer, [&](const std::string& component, const auto& moment) {
    answer->currentState = static_cast<float>(component == "/input/squeeze/value" ? moment.squeeze : moment.trigger);
  });
}

XRAPI_ATTR XrResult XRAPI_CALL stateBoolean(XrSession /*session*/, const XrActionStateGetInfo* info,
                                            XrActionStateBoolean* answer) {
  answer->currentState = XR_FALSE;
  return giveState(info, XR_ACTION_TYPE_BOOLEAN_INPUT, answer, [&](const std::string& component, const auto& moment) {
    answer->currentState = component == moment.pressed ? XR_TRUE : XR_FALSE;
  });
}

XRAPI_ATTR XrResult XRAPI_CALL stateVector(XrSession /*session*/, const XrActionStateGetInfo* info,
                                           XrActionStateVector2f* answer) {
  answer->currentState = {0.0F, 0.0F};
  return giveState(
      info, XR_ACTION_TYPE_VECTOR2F_INPUT, answer, [&](const std::string& /*component*/, const auto& moment) {
        answer->currentState = {static_cast<float>(moment.stick.x()), static_cast<float>(moment.stick.y())};
      });
}

XRAPI_ATTR XrResult XRAPI_CALL statePose(XrSession /*session*/, const XrActionStateGetInfo* info,
                                         XrActionStatePose* answer) {
  return giveState(info, XR_ACTION_TYPE_POSE_INPUT, answer, [](const std::string& /*component*/, const auto&) {});
}

XRAPI_ATTR XrResult XRAPI_CALL createActionSpace(XrSession /*session*/, const XrActionSpaceCreateInfo* info,
                                                 XrSpace* space) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = sessionResult(state); result != XR_SUCCESS) return result;
  *space = newHandle<XrSpace>(state);
  state.actionSpaces[reinterpret_cast<std::uint64_t>(*space)] = info->subactionPath;
  ++state.spaces;
  return XR_SUCCESS;
}

/// Locates a controller; grip and aim are the same pose.
XRAPI_ATTR XrResult XRAPI_CALL locateSpace(XrSpace space, XrSpace /*base*/, XrTime /*time*/,
                                           XrSpaceLocation* location) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = callResult(state); result != XR_SUCCESS) return result;
  const ControllerMoment& moment = momentOf(state, state.actionSpaces.at(reinterpret_cast<std::uint64_t>(space)));
  location->locationFlags = 0;
  location->pose = toXr(moment.X_RG);
  if (!moment.isThere) return XR_SUCCESS;
  location->locationFlags = XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
  if (!moment.isTracked) return XR_SUCCESS;
  location->locationFlags |= XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL applyHaptic(XrSession /*session*/, const XrHapticActionInfo* info,
                                           const XrHapticBaseHeader* feedback) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = callResult(state); result != XR_SUCCESS) return result;
  const auto* vibration = reinterpret_cast<const XrHapticVibration*>(feedback);
  if (vibration->type != XR_TYPE_HAPTIC_VIBRATION) return XR_ERROR_VALIDATION_FAILURE;
  const std::size_t hand = textOf(state, info->subactionPath) == kHands[0] ? 0 : 1;
  if (vibration->amplitude > 0.0F && vibration->amplitude <= 1.0F) {
    state.controllers[hand].pulses.push_back(static_cast<double>(vibration->amplitude));
  } else {
    complainOf(state, "a pulse is out of range");
  }
  return XR_SUCCESS;
}

}  // namespace

PFN_xrVoidFunction actionFunction(const char* name) {
  const std::pair<const char*, PFN_xrVoidFunction> functions[] = {
      {"xrStringToPath", reinterpret_cast<PFN_xrVoidFunction>(stringToPath)},
      {"xrPathToString", reinterpret_cast<PFN_xrVoidFunction>(pathToString)},
      {"xrCreateActionSet", reinterpret_cast<PFN_xrVoidFunction>(createActionSet)},
      {"xrDestroyActionSet", reinterpret_cast<PFN_xrVoidFunction>(destroyActionSet)},
      {"xrCreateAction", reinterpret_cast<PFN_xrVoidFunction>(createAction)},
      {"xrDestroyAction", reinterpret_cast<PFN_xrVoidFunction>(destroyAction)},
      {"xrSuggestInteractionProfileBindings", reinterpret_cast<PFN_xrVoidFunction>(suggestBindings)},
      {"xrAttachSessionActionSets", reinterpret_cast<PFN_xrVoidFunction>(attachActionSets)},
      {"xrGetCurrentInteractionProfile", reinterpret_cast<PFN_xrVoidFunction>(currentProfile)},
      {"xrSyncActions", reinterpret_cast<PFN_xrVoidFunction>(syncActions)},
      {"xrGetActionStateFloat", reinterpret_cast<PFN_xrVoidFunction>(stateFloat)},
      {"xrGetActionStateBoolean", reinterpret_cast<PFN_xrVoidFunction>(stateBoolean)},
      {"xrGetActionStateVector2f", reinterpret_cast<PFN_xrVoidFunction>(stateVector)},
      {"xrGetActionStatePose", reinterpret_cast<PFN_xrVoidFunction>(statePose)},
      {"xrCreateActionSpace", reinterpret_cast<PFN_xrVoidFunction>(createActionSpace)},
      {"xrLocateSpace", reinterpret_cast<PFN_xrVoidFunction>(locateSpace)},
      {"xrApplyHapticFeedback", reinterpret_cast<PFN_xrVoidFunction>(applyHaptic)},
  };
  for (const auto& [known, function] : functions) {
    if (std::strcmp(known, name) == 0) return function;
  }
  return nullptr;
}

}  // namespace glissade::test
