// The state of the runtime for tests. It is in the library's own memory, because OpenXR's functions have no argument
// for it.
#pragma once

#include <openxr/openxr.h>

#include <bit>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <random>

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

/// An action of the program, and its component for each hand.
struct FakeAction {
  XrActionType type = XR_ACTION_TYPE_BOOLEAN_INPUT;
  std::map<std::string, std::string> bound;  ///< component by hand
};

/// A controller with its state and its script.
struct FakeController {
  using Time = std::chrono::steady_clock::time_point;

  void put(const ControllerMoment& moment, Time now);
  /// Takes the next moment from the script if it is due. It takes one moment at most, so that the program sees each of
  /// them.
  void advanceTo(Time now);

  ControllerMoment shown;    ///< state for the program
  ControllerMoment reached;  ///< last moment of the script that was reached
  Time since{};              ///< time at which it was reached
  std::deque<ControllerMoment> script;
  std::vector<double> pulses;
};

/// Small pictures, so that software draws them quickly.
inline constexpr int kUsualEyePixels = 320;
inline constexpr std::chrono::nanoseconds kPeriod{11'111'111};  ///< 90 Hz

struct RuntimeState {
  std::mutex mutex;
  std::condition_variable changed;

  // The following are set by the script.
  bool runtimeThere = true;
  bool headsetThere = true;
  bool worn = true;
  int eyePixels = kUsualEyePixels;
  Pose X_RH{Vector3(0.0, 1.6, 0.0), Quaternion::Identity()};
  std::array<FakeController, 2> controllers;
  std::chrono::milliseconds stall{0};
  std::chrono::nanoseconds pictureInterval = kPeriod;
  std::chrono::nanoseconds displayTime{1};  ///< time of the last picture that was wanted, on a separate clock
  bool sessionLost = false;
  bool runtimeLost = false;
  int refusals = 0;           ///< number of calls that are still to be refused
  std::minstd_rand refusing;  ///< chooses them

  // The following are objects and states of the program.
  std::uint64_t nextHandle = 1;
  XrInstance instance = XR_NULL_HANDLE;
  XrSession session = XR_NULL_HANDLE;
  void* context = nullptr;  ///< OpenGL context of the session
  bool begun = false;       ///< the session has begun
  XrSessionState sessionState = XR_SESSION_STATE_UNKNOWN;
  bool leaving = false;
  std::map<std::uint64_t, FakeSwapchain> swapchains;
  int spaces = 0;
  std::vector<std::string> paths;  ///< XrPath is one more than the index
  int actionSets = 0;
  bool attached = false;  ///< an action set is attached to the session
  std::map<std::uint64_t, FakeAction> actions;
  std::map<std::uint64_t, XrPath> actionSpaces;  ///< the hand of each action space
  std::deque<XrSessionState> events;
  std::chrono::steady_clock::time_point nextFrame{};
  bool waited = false;  ///< a frame was waited for and has not begun
  bool inFrame = false;

  // The following are records for the test.
  int shown = 0;
  int sessions = 0;
  int syncs = 0;
  bool picturesWanted = false;
  std::vector<EyePicture> pictures;
  std::vector<std::string> complaints;
};

RuntimeState& runtimeState();

/// Changes the state of the session and tells the program. Precondition: the caller holds the mutex.
void changeSessionState(RuntimeState& state, XrSessionState to);
/// Changes the state of the session as the person wants, one state after the other and none twice: it ends when the
/// headset is taken off or the program is left, and begins when it is worn. Precondition: the caller holds the mutex.
void followPerson(RuntimeState& state);
void complainOf(RuntimeState& state, const std::string& what);
/// XR_SUCCESS, or the present failure of calls. Precondition: the caller holds the mutex.
XrResult instanceResult(const RuntimeState& state);
XrResult sessionResult(const RuntimeState& state);
/// XR_SUCCESS, or the failure of a call of pictures or controllers, which may be refused although nothing is lost.
/// Precondition: the caller holds the mutex.
XrResult callResult(RuntimeState& state);

template <class Handle>
Handle newHandle(RuntimeState& state) {
  return std::bit_cast<Handle>(state.nextHandle++);
}

// Functions of OpenXR, by the files that define them; null if there is none.
PFN_xrVoidFunction instanceFunction(const char* name);
PFN_xrVoidFunction sessionFunction(const char* name);
PFN_xrVoidFunction pictureFunction(const char* name);
PFN_xrVoidFunction actionFunction(const char* name);

}  // namespace glissade::test
