#include "widgets/openxr/headset_runtime.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "widgets/openxr/headset_failure.h"

namespace glissade {
namespace {

constexpr const char* kOpenGl = "XR_KHR_opengl_enable";

bool takesOpenGl() {
  std::uint32_t count = 0;
  checkXr(xrEnumerateInstanceExtensionProperties(nullptr, 0, &count, nullptr), "xrEnumerateInstanceExtensionProperties",
          HeadsetTrouble::NoRuntime);
  XrExtensionProperties empty{};
  empty.type = XR_TYPE_EXTENSION_PROPERTIES;
  std::vector<XrExtensionProperties> extensions(count, empty);
  checkXr(xrEnumerateInstanceExtensionProperties(nullptr, count, &count, extensions.data()),
          "xrEnumerateInstanceExtensionProperties", HeadsetTrouble::NoRuntime);
  return std::any_of(extensions.begin(), extensions.end(), [](const XrExtensionProperties& extension) {
    return std::strcmp(extension.extensionName, kOpenGl) == 0;
  });
}

}  // namespace

HeadsetRuntime::HeadsetRuntime() {
  if (!takesOpenGl()) throw HeadsetFailure(HeadsetTrouble::NoOpenGl, "");
  create();
  try {
    findHeadset();
  } catch (const HeadsetFailure&) {
    xrDestroyInstance(instance_);
    throw;
  }
}

HeadsetRuntime::~HeadsetRuntime() { xrDestroyInstance(instance_); }

void HeadsetRuntime::create() {
  XrInstanceCreateInfo info{};
  info.type = XR_TYPE_INSTANCE_CREATE_INFO;
  std::strcpy(info.applicationInfo.applicationName, "Glissade");
  info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
  info.enabledExtensionCount = 1;
  info.enabledExtensionNames = &kOpenGl;
  checkXr(xrCreateInstance(&info, &instance_), "xrCreateInstance", HeadsetTrouble::NoRuntime);
}

void HeadsetRuntime::findHeadset() {
  XrSystemGetInfo info{};
  info.type = XR_TYPE_SYSTEM_GET_INFO;
  info.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
  checkXr(xrGetSystem(instance_, &info, &system_), "xrGetSystem", HeadsetTrouble::NoHeadset);
  XrSystemProperties properties{};
  properties.type = XR_TYPE_SYSTEM_PROPERTIES;
  checkXr(xrGetSystemProperties(instance_, system_, &properties), "xrGetSystemProperties");
  name_ = properties.systemName;
}

PFN_xrVoidFunction HeadsetRuntime::function(const char* name) const {
  PFN_xrVoidFunction function = nullptr;
  return XR_SUCCEEDED(xrGetInstanceProcAddr(instance_, name, &function)) ? function : nullptr;
}

}  // namespace glissade
