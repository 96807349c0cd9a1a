#pragma once

#include <openxr/openxr.h>

#include <string>

namespace glissade {

/// The connection with the OpenXR runtime of this machine, and the headset that it has. Functions throw HeadsetFailure.
class HeadsetRuntime {
 public:
  HeadsetRuntime();
  ~HeadsetRuntime();
  HeadsetRuntime(const HeadsetRuntime&) = delete;
  HeadsetRuntime& operator=(const HeadsetRuntime&) = delete;

  XrInstance instance() const { return instance_; }
  XrSystemId system() const { return system_; }
  /// Of the headset, as the runtime calls it.
  const std::string& name() const { return name_; }
  /// Of an extension; null where the runtime has none.
  PFN_xrVoidFunction function(const char* name) const;

 private:
  void create();
  void findHeadset();

  XrInstance instance_ = XR_NULL_HANDLE;
  XrSystemId system_ = XR_NULL_SYSTEM_ID;
  std::string name_;
};

}  // namespace glissade
