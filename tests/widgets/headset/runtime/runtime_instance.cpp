// Instance, headset and events of the runtime for tests, and the look-up of its functions by the loader.
#include <algorithm>
#include <cstring>
#include <utility>

#include "tests/widgets/headset/runtime/runtime_state.h"

#define XR_USE_PLATFORM_XLIB
#define XR_USE_GRAPHICS_API_OPENGL
#include <GL/glx.h>
#include <openxr/openxr_platform.h>

namespace glissade::test {
namespace {

using Lock = std::lock_guard<std::mutex>;

constexpr XrSystemId kSystem = 1;

XRAPI_ATTR XrResult XRAPI_CALL getProcAddr(XrInstance instance, const char* name, PFN_xrVoidFunction* function);

XRAPI_ATTR XrResult XRAPI_CALL enumerateExtensions(const char* /*layer*/, std::uint32_t capacity, std::uint32_t* count,
                                                   XrExtensionProperties* properties) {
  *count = 1;
  if (capacity == 0) return XR_SUCCESS;
  std::strcpy(properties[0].extensionName, XR_KHR_OPENGL_ENABLE_EXTENSION_NAME);
  properties[0].extensionVersion = XR_KHR_opengl_enable_SPEC_VERSION;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL createInstance(const XrInstanceCreateInfo* /*info*/, XrInstance* instance) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (!state.runtimeThere) return XR_ERROR_RUNTIME_FAILURE;
  if (state.instance != XR_NULL_HANDLE) complainOf(state, "a second instance");
  state.runtimeLost = false;
  state.events.clear();
  state.instance = newHandle<XrInstance>(state);
  *instance = state.instance;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL destroyInstance(XrInstance /*instance*/) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (state.session != XR_NULL_HANDLE) complainOf(state, "an instance is destroyed before its session");
  state.instance = XR_NULL_HANDLE;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL getInstanceProperties(XrInstance /*instance*/, XrInstanceProperties* properties) {
  properties->runtimeVersion = XR_MAKE_VERSION(1, 0, 0);
  std::strcpy(properties->runtimeName, "Runtime for tests");
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL getSystem(XrInstance /*instance*/, const XrSystemGetInfo* /*info*/, XrSystemId* id) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (state.runtimeLost) return XR_ERROR_INSTANCE_LOST;
  if (!state.headsetThere) return XR_ERROR_FORM_FACTOR_UNAVAILABLE;
  *id = kSystem;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL getSystemProperties(XrInstance /*instance*/, XrSystemId id,
                                                   XrSystemProperties* properties) {
  properties->systemId = id;
  std::strcpy(properties->systemName, "Scripted headset");
  properties->graphicsProperties = {4096, 4096, 16};
  properties->trackingProperties = {XR_TRUE, XR_TRUE};
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL pollEvent(XrInstance /*instance*/, XrEventDataBuffer* buffer) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  if (state.runtimeLost || !state.runtimeThere) return XR_ERROR_INSTANCE_LOST;
  if (state.events.empty()) return XR_EVENT_UNAVAILABLE;
  auto* event = reinterpret_cast<XrEventDataSessionStateChanged*>(buffer);
  event->type = XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED;
  event->next = nullptr;
  event->session = state.session;
  event->state = state.events.front();
  event->time = 1;
  state.events.pop_front();
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL enumerateViewConfigurationViews(XrInstance /*instance*/, XrSystemId /*id*/,
                                                               XrViewConfigurationType /*type*/, std::uint32_t capacity,
                                                               std::uint32_t* count, XrViewConfigurationView* views) {
  RuntimeState& state = runtimeState();
  const Lock lock(state.mutex);
  const auto pixels = static_cast<std::uint32_t>(state.eyePixels);
  *count = 2;
  for (std::uint32_t i = 0; i < std::min(capacity, *count); ++i) {
    views[i].recommendedImageRectWidth = views[i].maxImageRectWidth = pixels;
    views[i].recommendedImageRectHeight = views[i].maxImageRectHeight = pixels;
    views[i].recommendedSwapchainSampleCount = views[i].maxSwapchainSampleCount = 1;
  }
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL getGraphicsRequirements(XrInstance /*instance*/, XrSystemId /*id*/,
                                                       XrGraphicsRequirementsOpenGLKHR* requirements) {
  requirements->minApiVersionSupported = XR_MAKE_VERSION(2, 1, 0);
  requirements->maxApiVersionSupported = XR_MAKE_VERSION(4, 6, 0);
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL getProcAddr(XrInstance /*instance*/, const char* name, PFN_xrVoidFunction* function) {
  for (const auto find : {instanceFunction, sessionFunction, pictureFunction, actionFunction}) {
    *function = find(name);
    if (*function != nullptr) return XR_SUCCESS;
  }
  return XR_ERROR_FUNCTION_UNSUPPORTED;
}

}  // namespace

PFN_xrVoidFunction instanceFunction(const char* name) {
  const std::pair<const char*, PFN_xrVoidFunction> functions[] = {
      {"xrGetInstanceProcAddr", reinterpret_cast<PFN_xrVoidFunction>(getProcAddr)},
      {"xrEnumerateInstanceExtensionProperties", reinterpret_cast<PFN_xrVoidFunction>(enumerateExtensions)},
      {"xrCreateInstance", reinterpret_cast<PFN_xrVoidFunction>(createInstance)},
      {"xrDestroyInstance", reinterpret_cast<PFN_xrVoidFunction>(destroyInstance)},
      {"xrGetInstanceProperties", reinterpret_cast<PFN_xrVoidFunction>(getInstanceProperties)},
      {"xrGetSystem", reinterpret_cast<PFN_xrVoidFunction>(getSystem)},
      {"xrGetSystemProperties", reinterpret_cast<PFN_xrVoidFunction>(getSystemProperties)},
      {"xrPollEvent", reinterpret_cast<PFN_xrVoidFunction>(pollEvent)},
      {"xrEnumerateViewConfigurationViews", reinterpret_cast<PFN_xrVoidFunction>(enumerateViewConfigurationViews)},
      {"xrGetOpenGLGraphicsRequirementsKHR", reinterpret_cast<PFN_xrVoidFunction>(getGraphicsRequirements)},
  };
  for (const auto& [known, function] : functions) {
    if (std::strcmp(known, name) == 0) return function;
  }
  return nullptr;
}

/// Declarations of loader_interfaces.h, which Debian does not provide.
struct LoaderInfo {
  std::uint32_t type;
  std::uint32_t version;
  std::size_t size;
  std::uint32_t minInterface;
  std::uint32_t maxInterface;
  XrVersion minApi;
  XrVersion maxApi;
};
struct RuntimeRequest {
  std::uint32_t type;
  std::uint32_t version;
  std::size_t size;
  std::uint32_t interfaceVersion;
  XrVersion apiVersion;
  PFN_xrGetInstanceProcAddr getInstanceProcAddr;
};

extern "C" __attribute__((visibility("default"))) XrResult xrNegotiateLoaderRuntimeInterface(const LoaderInfo* /*info*/,
                                                                                             RuntimeRequest* request) {
  request->interfaceVersion = 1;
  request->apiVersion = XR_CURRENT_API_VERSION;
  request->getInstanceProcAddr = getProcAddr;
  return XR_SUCCESS;
}

}  // namespace glissade::test
