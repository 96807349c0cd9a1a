#include "widgets/openxr/headset_failure.h"

namespace glissade {

void checkXr(XrResult result, const char* call, HeadsetTrouble otherwise) {
  if (XR_SUCCEEDED(result)) return;
  const std::string detail = std::string(call) + " " + std::to_string(result);
  switch (result) {
    case XR_ERROR_SESSION_LOST: throw HeadsetFailure(HeadsetTrouble::SessionLost, detail);
    case XR_ERROR_INSTANCE_LOST: throw HeadsetFailure(HeadsetTrouble::RuntimeLost, detail);
    case XR_ERROR_FORM_FACTOR_UNAVAILABLE: throw HeadsetFailure(HeadsetTrouble::NoHeadset, detail);
    default: throw HeadsetFailure(otherwise, detail);
  }
}

}  // namespace glissade
