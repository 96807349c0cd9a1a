#include "widgets/openxr/headset_session.h"

#include <algorithm>

// These headers come last, because their macros are common words.
#define XR_USE_PLATFORM_XLIB
#define XR_USE_GRAPHICS_API_OPENGL
#include <GL/glx.h>
#include <openxr/openxr_platform.h>

namespace glissade {
namespace {

constexpr XrViewConfigurationType kBothEyes = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
/// Height of a seated person's head above the floor in metres, for runtimes that do not know the floor.
constexpr float kSeatedHeight = 1.2F;

bool knowsFloor(XrSession session) {
  std::uint32_t count = 0;
  checkXr(xrEnumerateReferenceSpaces(session, 0, &count, nullptr), "xrEnumerateReferenceSpaces");
  std::vector<XrReferenceSpaceType> spaces(count);
  checkXr(xrEnumerateReferenceSpaces(session, count, &count, spaces.data()), "xrEnumerateReferenceSpaces");
  return std::count(spaces.begin(), spaces.end(), XR_REFERENCE_SPACE_TYPE_STAGE) > 0;
}

}  // namespace

HeadsetSession::HeadsetSession(const HeadsetRuntime& runtime, const GlxHandles& handles) : runtime_(runtime) {
  create(handles);
  try {
    makeRoom();
  } catch (const HeadsetFailure&) {
    xrDestroySession(session_);
    throw;
  }
}

HeadsetSession::~HeadsetSession() {
  xrDestroySpace(room_);
  xrDestroySession(session_);
}

/// Asks for the runtime's requirements, as OpenXR demands. Each context of this program meets them.
void HeadsetSession::create(const GlxHandles& handles) {
  const auto requirements =
      reinterpret_cast<PFN_xrGetOpenGLGraphicsRequirementsKHR>(runtime_.function("xrGetOpenGLGraphicsRequirementsKHR"));
  if (requirements == nullptr) throw HeadsetFailure(HeadsetTrouble::NoOpenGl, "");
  XrGraphicsRequirementsOpenGLKHR required{};
  required.type = XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR;
  checkXr(requirements(runtime_.instance(), runtime_.system(), &required), "xrGetOpenGLGraphicsRequirementsKHR");
  XrGraphicsBindingOpenGLXlibKHR binding{};
  binding.type = XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR;
  binding.xDisplay = static_cast<Display*>(handles.display);
  binding.visualid = static_cast<std::uint32_t>(handles.visual);
  binding.glxFBConfig = static_cast<GLXFBConfig>(handles.framebufferConfig);
  binding.glxDrawable = handles.drawable;
  binding.glxContext = static_cast<GLXContext>(handles.context);
  XrSessionCreateInfo info{};
  info.type = XR_TYPE_SESSION_CREATE_INFO;
  info.next = &binding;
  info.systemId = runtime_.system();
  checkXr(xrCreateSession(runtime_.instance(), &info, &session_), "xrCreateSession");
}

void HeadsetSession::makeRoom() {
  XrReferenceSpaceCreateInfo info{};
  info.type = XR_TYPE_REFERENCE_SPACE_CREATE_INFO;
  info.poseInReferenceSpace.orientation.w = 1.0F;
  info.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_STAGE;
  if (!knowsFloor(session_)) {
    info.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_LOCAL;
    info.poseInReferenceSpace.position.y = -kSeatedHeight;
  }
  checkXr(xrCreateReferenceSpace(session_, &info, &room_), "xrCreateReferenceSpace");
}

SessionChange HeadsetSession::poll() {
  XrEventDataBuffer event{};
  for (;;) {
    event.type = XR_TYPE_EVENT_DATA_BUFFER;
    event.next = nullptr;
    const XrResult result = xrPollEvent(runtime_.instance(), &event);
    checkXr(result, "xrPollEvent");
    if (result == XR_EVENT_UNAVAILABLE) return SessionChange::Nothing;
    const SessionChange found = take(event);
    if (found != SessionChange::Nothing) return found;
  }
}

SessionChange HeadsetSession::take(const XrEventDataBuffer& event) {
  if (event.type == XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING) {
    throw HeadsetFailure(HeadsetTrouble::RuntimeLost, "the runtime ends");
  }
  if (event.type != XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) return SessionChange::Nothing;
  return change(reinterpret_cast<const XrEventDataSessionStateChanged&>(event).state);
}

SessionChange HeadsetSession::change(XrSessionState state) {
  switch (state) {
    case XR_SESSION_STATE_READY: {
      XrSessionBeginInfo info{};
      info.type = XR_TYPE_SESSION_BEGIN_INFO;
      info.primaryViewConfigurationType = kBothEyes;
      checkXr(xrBeginSession(session_, &info), "xrBeginSession");
      return SessionChange::Began;
    }
    case XR_SESSION_STATE_STOPPING: checkXr(xrEndSession(session_), "xrEndSession"); return SessionChange::Ended;
    case XR_SESSION_STATE_EXITING: return SessionChange::Left;
    case XR_SESSION_STATE_LOSS_PENDING: return SessionChange::Lost;
    default: return SessionChange::Nothing;
  }
}

std::optional<XrFrameState> HeadsetSession::beginPicture() {
  XrFrameWaitInfo wait{};
  wait.type = XR_TYPE_FRAME_WAIT_INFO;
  XrFrameState state{};
  state.type = XR_TYPE_FRAME_STATE;
  if (!refused_.accept(xrWaitFrame(session_, &wait, &state), "xrWaitFrame")) return std::nullopt;
  XrFrameBeginInfo begin{};
  begin.type = XR_TYPE_FRAME_BEGIN_INFO;
  if (!refused_.accept(xrBeginFrame(session_, &begin), "xrBeginFrame")) return std::nullopt;
  return state;
}

bool HeadsetSession::locate(XrTime time, EyeViews& views) {
  for (XrView& view : views) {
    view = {};
    view.type = XR_TYPE_VIEW;
  }
  XrViewLocateInfo info{};
  info.type = XR_TYPE_VIEW_LOCATE_INFO;
  info.viewConfigurationType = kBothEyes;
  info.displayTime = time;
  info.space = room_;
  XrViewState state{};
  state.type = XR_TYPE_VIEW_STATE;
  std::uint32_t count = 0;
  const auto capacity = static_cast<std::uint32_t>(views.size());
  if (!refused_.accept(xrLocateViews(session_, &info, &state, capacity, &count, views.data()), "xrLocateViews")) {
    return false;
  }
  constexpr XrViewStateFlags kBoth = XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT;
  return count == views.size() && (state.viewStateFlags & kBoth) == kBoth;
}

void HeadsetSession::endFrame(XrTime time, const XrCompositionLayerProjection* layer) {
  const auto* layers = reinterpret_cast<const XrCompositionLayerBaseHeader*>(layer);
  XrFrameEndInfo info{};
  info.type = XR_TYPE_FRAME_END_INFO;
  info.displayTime = time;
  info.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  info.layerCount = layer != nullptr ? 1 : 0;
  info.layers = layer != nullptr ? &layers : nullptr;
  refused_.accept(xrEndFrame(session_, &info), "xrEndFrame");
}

}  // namespace glissade
