#include "widgets/openxr/headset_failure.h"

namespace glissade {
namespace {

std::string detailOf(XrResult result, const char* call) { return std::string(call) + " " + std::to_string(result); }

}  // namespace

void checkXr(XrResult result, const char* call, HeadsetTrouble otherwise) {
  if (XR_SUCCEEDED(result)) return;
  const std::string detail = detailOf(result, call);
  switch (result) {
    case XR_ERROR_SESSION_LOST: throw HeadsetFailure(HeadsetTrouble::SessionLost, detail);
    case XR_ERROR_INSTANCE_LOST: throw HeadsetFailure(HeadsetTrouble::RuntimeLost, detail);
    case XR_ERROR_FORM_FACTOR_UNAVAILABLE: throw HeadsetFailure(HeadsetTrouble::NoHeadset, detail);
    default: throw HeadsetFailure(otherwise, detail);
  }
}

bool RefusedCalls::accept(XrResult result, const char* call) {
  if (XR_SUCCEEDED(result)) return true;
  if (result == XR_ERROR_SESSION_LOST || result == XR_ERROR_INSTANCE_LOST) checkXr(result, call);
  if (first_.empty()) first_ = detailOf(result, call);
  return false;
}

}  // namespace glissade
