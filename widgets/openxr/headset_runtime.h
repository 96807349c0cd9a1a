#pragma once

#include <openxr/openxr.h>

#include <string>

namespace glissade {

/// The connection with the OpenXR runtime of this machine and with its headset. Functions throw HeadsetFailure.
class HeadsetRuntime {
 public:
  HeadsetRuntime();
  ~HeadsetRuntime();
  HeadsetRuntime(const HeadsetRuntime&) = delete;
  HeadsetRuntime& operator=(const HeadsetRuntime&) = delete;

  XrInstance instance() const { return instance_; }
  XrSystemId system() const { return system_; }
  /// Name of the headset by the runtime.
  const std::string& name() const { return name_; }
  /// Function of an extension; null if the runtime does not have it.
  PFN_xrVoidFunction function(const char* name) const;

 private:
  void create();
  void findHeadset();

  XrInstance instance_ = XR_NULL_HANDLE;
  XrSystemId system_ = XR_NULL_SYSTEM_ID;
  std::string name_;
};

}  // namespace glissade
