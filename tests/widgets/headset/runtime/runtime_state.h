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

struct RuntimeState {
  std::mutex mutex;
  std::condition_variable changed;

  // The script.
  bool runtimeThere = true;
  bool headsetThere = true;
  bool worn = true;
  Pose X_RH{Vector3(0.0, 1.6, 0.0), Quaternion::Identity()};
  std::chrono::milliseconds stall{0};
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
  std::deque<XrSessionState> events;
  std::chrono::steady_clock::time_point nextFrame{};
  bool waited = false;  ///< for a frame that has not begun
  bool inFrame = false;

  // What is known about it afterwards.
  int shown = 0;
  int sessions = 0;
  bool picturesWanted = false;
  std::vector<EyePicture> pictures;
  std::vector<std::string> complaints;
};

RuntimeState& runtimeState();

/// The state of the session becomes this one, and the program is told. The mutex is held.
void changeSessionState(RuntimeState& state, XrSessionState to);
void complainOf(RuntimeState& state, const std::string& what);
/// XR_SUCCESS, or how a call fails now. The mutex is held.
XrResult sessionResult(const RuntimeState& state);

template <class Handle>
Handle newHandle(RuntimeState& state) {
  return std::bit_cast<Handle>(state.nextHandle++);
}

// Of OpenXR, by the files that have them; null where there is none.
PFN_xrVoidFunction instanceFunction(const char* name);
PFN_xrVoidFunction sessionFunction(const char* name);
PFN_xrVoidFunction pictureFunction(const char* name);

}  // namespace glissade::test
