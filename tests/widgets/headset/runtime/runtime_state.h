// The state of the runtime for tests. OpenXR's functions have no place for it but the library's own memory.
#pragma once

#include <openxr/openxr.h>

#include <bit>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>

#include "tests/widgets/headset/runtime/headset_script.h"

namespace glissade::test {

/// Pictures of one eye: textures of the program's context.
struct FakeSwapchain {
  int width = 0;
  int height = 0;
  std::vector<unsigned> textures;
  std::size_t next = 0;
  bool acquired = false;
};

/// An action of the program, and what of each hand it is bound to.
struct FakeAction {
  XrActionType type = XR_ACTION_TYPE_BOOLEAN_INPUT;
  std::map<std::string, std::string> bound;  ///< component by hand
};

/// A controller: where it is, and what the script lets it do next.
struct FakeController {
  using Time = std::chrono::steady_clock::time_point;

  void put(const ControllerMoment& moment, Time now);
  /// Takes from the script what is due, one moment at most, so that the program sees each of them.
  void goOn(Time now);

  ControllerMoment shown;    ///< to the program
  ControllerMoment reached;  ///< the last of the script
  Time since{};              ///< it was reached
  std::deque<ControllerMoment> script;
  std::vector<double> pulses;
};

/// Few, so that software draws them quickly.
inline constexpr int kUsualEyePixels = 320;
inline constexpr std::chrono::nanoseconds kPeriod{11'111'111};  ///< 90 Hz

struct RuntimeState {
  std::mutex mutex;
  std::condition_variable changed;

  // The script.
  bool runtimeThere = true;
  bool headsetThere = true;
  bool worn = true;
  int eyePixels = kUsualEyePixels;
  Pose X_RH{Vector3(0.0, 1.6, 0.0), Quaternion::Identity()};
  std::array<FakeController, 2> controllers;
  std::chrono::milliseconds stall{0};
  std::chrono::nanoseconds pictureInterval = kPeriod;
  std::chrono::nanoseconds displayTime{1};  ///< of the last picture that was wanted, in a clock of its own
  bool sessionLost = false;
  bool runtimeLost = false;

  // What the program holds.
  std::uint64_t nextHandle = 1;
  XrInstance instance = XR_NULL_HANDLE;
  XrSession session = XR_NULL_HANDLE;
  void* context = nullptr;  ///< OpenGL's, of the session
  bool begun = false;       ///< the session
  XrSessionState sessionState = XR_SESSION_STATE_UNKNOWN;
  bool leaving = false;
  std::map<std::uint64_t, FakeSwapchain> swapchains;
  int spaces = 0;
  std::vector<std::string> paths;  ///< XrPath is one more than the index
  int actionSets = 0;
  bool attached = false;  ///< an action set, to the session
  std::map<std::uint64_t, FakeAction> actions;
  std::map<std::uint64_t, XrPath> actionSpaces;  ///< the hand of each
  std::deque<XrSessionState> events;
  std::chrono::steady_clock::time_point nextFrame{};
  bool waited = false;  ///< for a frame that has not begun
  bool inFrame = false;

  // What is known about it afterwards.
  int shown = 0;
  int sessions = 0;
  int syncs = 0;
  bool picturesWanted = false;
  std::vector<EyePicture> pictures;
  std::vector<std::string> complaints;
};

RuntimeState& runtimeState();

/// The state of the session becomes this one, and the program is told. The mutex is held.
void changeSessionState(RuntimeState& state, XrSessionState to);
/// The session goes on to what the person wants of it, one state after the other and none twice: it ends where the
/// headset is taken off or the program is left, and begins where it is worn. The mutex is held.
void followPerson(RuntimeState& state);
void complainOf(RuntimeState& state, const std::string& what);
/// XR_SUCCESS, or how a call fails now. The mutex is held.
XrResult instanceResult(const RuntimeState& state);
XrResult sessionResult(const RuntimeState& state);

template <class Handle>
Handle newHandle(RuntimeState& state) {
  return std::bit_cast<Handle>(state.nextHandle++);
}

// Of OpenXR, by the files that have them; null where there is none.
PFN_xrVoidFunction instanceFunction(const char* name);
PFN_xrVoidFunction sessionFunction(const char* name);
PFN_xrVoidFunction pictureFunction(const char* name);
PFN_xrVoidFunction actionFunction(const char* name);

}  // namespace glissade::test
