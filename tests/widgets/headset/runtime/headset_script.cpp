#include "tests/widgets/headset/runtime/headset_script.h"

#include <cmath>

#include "tests/widgets/headset/runtime/runtime_state.h"

namespace glissade::test {
namespace {

constexpr double kEyeSeparation = 0.063;

ControllerMoment absentController() {
  ControllerMoment moment;
  moment.isThere = false;
  return moment;
}

/// Interpolates poses, because the library does not contain the engine.
Pose between(const Pose& a, const Pose& b, double t) {
  return {a.position + t * (b.position - a.position), a.orientation.slerp(t, b.orientation)};
}

template <class Change>
void change(Change change) {
  RuntimeState& state = runtimeState();
  const std::lock_guard lock(state.mutex);
  change(state);
  state.changed.notify_all();
}

template <class Value>
Value read(Value RuntimeState::*member) {
  RuntimeState& state = runtimeState();
  const std::lock_guard lock(state.mutex);
  return state.*member;
}

}  // namespace

RuntimeState& runtimeState() {
  static RuntimeState state;
  return state;
}

void changeSessionState(RuntimeState& state, XrSessionState to) {
  state.sessionState = to;
  state.events.push_back(to);
}

void followPerson(RuntimeState& state) {
  if (state.session == XR_NULL_HANDLE) return;
  const bool isUsed = state.worn && !state.leaving;
  if (state.begun) {
    if (!isUsed && state.sessionState != XR_SESSION_STATE_STOPPING) {
      changeSessionState(state, XR_SESSION_STATE_STOPPING);
    }
  } else if (state.sessionState == XR_SESSION_STATE_IDLE) {
    if (state.leaving) {
      changeSessionState(state, XR_SESSION_STATE_EXITING);
    } else if (state.worn) {
      changeSessionState(state, XR_SESSION_STATE_READY);
    }
  }
}

void complainOf(RuntimeState& state, const std::string& what) { state.complaints.push_back(what); }

XrResult instanceResult(const RuntimeState& state) {
  return state.runtimeLost || !state.runtimeThere ? XR_ERROR_INSTANCE_LOST : XR_SUCCESS;
}

XrResult sessionResult(const RuntimeState& state) {
  if (const XrResult result = instanceResult(state); result != XR_SUCCESS) return result;
  if (state.sessionLost) return XR_ERROR_SESSION_LOST;
  return XR_SUCCESS;
}

XrResult callResult(RuntimeState& state) {
  const XrResult result = sessionResult(state);
  if (result != XR_SUCCESS || state.refusals == 0 || state.refusing() % 3 != 0) return result;
  --state.refusals;
  return XR_ERROR_PATH_UNSUPPORTED;
}

EyeSides scriptedSides(std::size_t eye) {
  const EyeSides left{-1.10, 0.90, -1.05, 0.95};
  return eye == 0 ? left : EyeSides{-left.right, -left.left, left.down, left.up};
}

Pose scriptedEye(std::size_t eye) {
  const double side = eye == 0 ? -1.0 : 1.0;
  return {Vector3(side * 0.5 * kEyeSeparation, 0.0, 0.0),
          Quaternion(Eigen::AngleAxisd(-side * 0.05, Vector3::UnitY()))};
}

void resetHeadset() {
  change([](RuntimeState& state) {
    state.runtimeThere = state.headsetThere = state.worn = true;
    state.eyePixels = kUsualEyePixels;
    state.pictureInterval = kPeriod;
    state.X_RH = {Vector3(0.0, 1.6, 0.0), Quaternion::Identity()};
    for (FakeController& controller : state.controllers) controller.put(absentController(), {});
    state.stall = {};
    state.picturesWanted = false;
    state.complaints.clear();
  });
}

void setRuntimeThere(bool there) {
  change([there](RuntimeState& state) { state.runtimeThere = there; });
}

void setHeadsetThere(bool there) {
  change([there](RuntimeState& state) { state.headsetThere = there; });
}

void setWorn(bool worn) {
  change([worn](RuntimeState& state) {
    state.worn = worn;
    followPerson(state);
  });
}

void setEyePixels(int pixels) {
  change([pixels](RuntimeState& state) { state.eyePixels = pixels; });
}

void setHead(const Pose& X_RH) {
  change([&X_RH](RuntimeState& state) { state.X_RH = X_RH; });
}

void setController(std::size_t hand, const ControllerMoment& moment) {
  change([&](RuntimeState& state) { state.controllers[hand].put(moment, std::chrono::steady_clock::now()); });
}

void playController(std::size_t hand, const std::vector<ControllerMoment>& moments) {
  change([&](RuntimeState& state) {
    FakeController& controller = state.controllers[hand];
    if (controller.script.empty()) controller.since = std::chrono::steady_clock::now();
    controller.script.insert(controller.script.end(), moments.begin(), moments.end());
  });
}

bool hasPlayed(std::size_t hand) {
  RuntimeState& state = runtimeState();
  const std::lock_guard lock(state.mutex);
  return state.controllers[hand].script.empty();
}

std::vector<double> takePulses(std::size_t hand) {
  std::vector<double> pulses;
  change([&](RuntimeState& state) { pulses.swap(state.controllers[hand].pulses); });
  return pulses;
}

int readControllers() { return read(&RuntimeState::syncs); }

void FakeController::put(const ControllerMoment& moment, Time now) { *this = {moment, moment, now, {}, {}}; }

void FakeController::advanceTo(Time now) {
  if (script.empty()) return;
  const ControllerMoment next = script.front();
  const double passed = std::chrono::duration<double>(now - since).count();
  if (passed < next.after) {
    shown = reached;
    shown.X_RG = between(reached.X_RG, next.X_RG, passed / next.after);
    return;
  }
  since += std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(next.after));
  reached = shown = next;
  script.pop_front();
}

void stallOnce(std::chrono::milliseconds duration) {
  change([duration](RuntimeState& state) { state.stall = duration; });
}

void refuse(int calls) {
  change([calls](RuntimeState& state) { state.refusals = calls; });
}

int callsToRefuse() { return read(&RuntimeState::refusals); }

void setPictureInterval(double seconds) {
  const auto interval = std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds));
  change([interval](RuntimeState& state) { state.pictureInterval = interval; });
}

void loseSession() {
  change([](RuntimeState& state) { state.sessionLost = state.session != XR_NULL_HANDLE; });
}

void loseRuntime() {
  change([](RuntimeState& state) { state.runtimeLost = state.instance != XR_NULL_HANDLE; });
}

void leaveProgram() {
  change([](RuntimeState& state) {
    state.leaving = state.session != XR_NULL_HANDLE;
    followPerson(state);
  });
}

int shownPictures() { return read(&RuntimeState::shown); }

int madeSessions() { return read(&RuntimeState::sessions); }

std::vector<std::string> complaints() { return read(&RuntimeState::complaints); }

int heldHandles() {
  RuntimeState& state = runtimeState();
  const std::lock_guard lock(state.mutex);
  return state.actionSets + (state.instance != XR_NULL_HANDLE ? 1 : 0) + (state.session != XR_NULL_HANDLE ? 1 : 0) +
         state.spaces + static_cast<int>(state.swapchains.size());
}

std::vector<EyePicture> nextPictures(std::chrono::milliseconds longest) {
  RuntimeState& state = runtimeState();
  std::unique_lock lock(state.mutex);
  state.pictures.clear();
  state.picturesWanted = true;
  state.changed.wait_for(lock, longest, [&state] { return !state.picturesWanted; });
  return state.pictures;
}

}  // namespace glissade::test
