// Session, spaces and times of the runtime for tests.
#include <algorithm>
#include <cstring>
#include <thread>
#include <utility>

#include "tests/widgets/headset/runtime/runtime_state.h"
#include "tests/widgets/headset/runtime/xr_values.h"

#define XR_USE_PLATFORM_XLIB
#define XR_USE_GRAPHICS_API_OPENGL
#include <GL/glx.h>
#include <openxr/openxr_platform.h>

namespace glissade::test {
namespace {

using Lock = std::lock_guard<std::mutex>;
using Clock = std::chrono::steady_clock;

XRAPI_ATTR XrResult XRAPI_CALL createSession(XrInstance /*instance*/, const XrSessionCreateInfo* info,
                                             XrSession* session) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (state.runtimeLost) return XR_ERROR_INSTANCE_LOST;
  const auto* binding = static_cast<const XrGraphicsBindingOpenGLXlibKHR*>(info->next);
  if (binding == nullptr || binding->type != XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR) {
    return XR_ERROR_GRAPHICS_DEVICE_INVALID;
  }
  if (binding->xDisplay == nullptr || binding->glxFBConfig == nullptr || binding->visualid == 0) {
    complainOf(state, "the binding is not complete");
  }
  state.attached = false;
  state.context = binding->glxContext;
  state.sessionLost = state.begun = state.leaving = state.waited = state.inFrame = false;
  state.session = newHandle<XrSession>(state);
  ++state.sessions;
  *session = state.session;
  changeSessionState(state, XR_SESSION_STATE_IDLE);
  followPerson(state);
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL destroySession(XrSession /*session*/) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (!state.swapchains.empty() || state.spaces != 0) complainOf(state, "a session is destroyed before what it holds");
  state.session = XR_NULL_HANDLE;
  state.begun = false;
  state.events.clear();
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL beginSession(XrSession /*session*/, const XrSessionBeginInfo* /*info*/) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = sessionResult(state); result != XR_SUCCESS) return result;
  if (state.begun) return XR_ERROR_SESSION_RUNNING;
  if (state.sessionState != XR_SESSION_STATE_READY) return XR_ERROR_SESSION_NOT_READY;
  state.begun = true;
  for (const XrSessionState next :
       {XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED}) {
    changeSessionState(state, next);
  }
  followPerson(state);  // the person may have taken the headset off meanwhile
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL endSession(XrSession /*session*/) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = sessionResult(state); result != XR_SUCCESS) return result;
  if (state.sessionState != XR_SESSION_STATE_STOPPING) return XR_ERROR_SESSION_NOT_STOPPING;
  state.begun = false;
  changeSessionState(state, XR_SESSION_STATE_IDLE);
  followPerson(state);
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL enumerateReferenceSpaces(XrSession /*session*/, std::uint32_t capacity,
                                                        std::uint32_t* count, XrReferenceSpaceType* spaces) {
  *count = 3;
  if (capacity < *count) return XR_SUCCESS;
  spaces[0] = XR_REFERENCE_SPACE_TYPE_VIEW;
  spaces[1] = XR_REFERENCE_SPACE_TYPE_LOCAL;
  spaces[2] = XR_REFERENCE_SPACE_TYPE_STAGE;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL createReferenceSpace(XrSession /*session*/, const XrReferenceSpaceCreateInfo* /*info*/,
                                                    XrSpace* space) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = sessionResult(state); result != XR_SUCCESS) return result;
  ++state.spaces;
  *space = newHandle<XrSpace>(state);
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL destroySpace(XrSpace space) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  --state.spaces;
  state.actionSpaces.erase(reinterpret_cast<std::uint64_t>(space));
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL waitFrame(XrSession /*session*/, const XrFrameWaitInfo* /*info*/, XrFrameState* frame) {
  RuntimeState& state = runtimeState();
  std::unique_lock lock(state.mutex);
  const Clock::time_point now = Clock::now();
  const auto stall = std::exchange(state.stall, {});
  state.nextFrame = std::max(state.nextFrame + kPeriod, now) + stall;
  const Clock::time_point until = state.nextFrame;
  lock.unlock();
  std::this_thread::sleep_until(until);
  lock.lock();
  if (const XrResult result = callResult(state); result != XR_SUCCESS) return result;
  if (!state.begun) return XR_ERROR_SESSION_NOT_RUNNING;
  state.waited = true;
  state.displayTime += state.pictureInterval;
  frame->predictedDisplayTime = state.displayTime.count();
  frame->predictedDisplayPeriod = kPeriod.count();
  frame->shouldRender = XR_TRUE;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL beginFrame(XrSession /*session*/, const XrFrameBeginInfo* /*info*/) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = callResult(state); result != XR_SUCCESS) return result;
  if (!state.waited) return XR_ERROR_CALL_ORDER_INVALID;
  state.waited = false;
  state.inFrame = true;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL locateViews(XrSession /*session*/, const XrViewLocateInfo* /*info*/,
                                           XrViewState* viewState, std::uint32_t capacity, std::uint32_t* count,
                                           XrView* views) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (const XrResult result = callResult(state); result != XR_SUCCESS) return result;
  viewState->viewStateFlags = XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT |
                              XR_VIEW_STATE_ORIENTATION_TRACKED_BIT | XR_VIEW_STATE_POSITION_TRACKED_BIT;
  *count = 2;
  for (std::uint32_t eye = 0; eye < std::min(capacity, *count); ++eye) {
    const Pose X_HE = scriptedEye(eye);
    views[eye].pose = toXr({state.X_RH * X_HE.position, state.X_RH.orientation * X_HE.orientation});
    views[eye].fov = toXr(scriptedSides(eye));
  }
  return XR_SUCCESS;
}

}  // namespace

PFN_xrVoidFunction sessionFunction(const char* name) {
  const std::pair<const char*, PFN_xrVoidFunction> functions[] = {
      {"xrCreateSession", reinterpret_cast<PFN_xrVoidFunction>(createSession)},
      {"xrDestroySession", reinterpret_cast<PFN_xrVoidFunction>(destroySession)},
      {"xrBeginSession", reinterpret_cast<PFN_xrVoidFunction>(beginSession)},
      {"xrEndSession", reinterpret_cast<PFN_xrVoidFunction>(endSession)},
      {"xrEnumerateReferenceSpaces", reinterpret_cast<PFN_xrVoidFunction>(enumerateReferenceSpaces)},
      {"xrCreateReferenceSpace", reinterpret_cast<PFN_xrVoidFunction>(createReferenceSpace)},
      {"xrDestroySpace", reinterpret_cast<PFN_xrVoidFunction>(destroySpace)},
      {"xrWaitFrame", reinterpret_cast<PFN_xrVoidFunction>(waitFrame)},
      {"xrBeginFrame", reinterpret_cast<PFN_xrVoidFunction>(beginFrame)},
      {"xrLocateViews", reinterpret_cast<PFN_xrVoidFunction>(locateViews)},
  };
  for (const auto& [known, function] : functions) {
    if (std::strcmp(known, name) == 0) return function;
  }
  return nullptr;
}

}  // namespace glissade::test
