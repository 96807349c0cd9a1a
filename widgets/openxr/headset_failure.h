#pragma once

#include <openxr/openxr.h>

#include <stdexcept>
#include <string>

#include "widgets/openxr/headset_machine.h"

namespace glissade {

/// Thrown by all code that calls the runtime, and caught at one place of the headset's thread. The text is the detail.
class HeadsetFailure : public std::runtime_error {
 public:
  HeadsetFailure(HeadsetTrouble trouble, const std::string& detail) : std::runtime_error(detail), trouble_(trouble) {}
  HeadsetTrouble trouble() const { return trouble_; }

 private:
  HeadsetTrouble trouble_;
};

/// Throws if `call` has failed. A result that names no trouble of its own gives `otherwise`.
void checkXr(XrResult result, const char* call, HeadsetTrouble otherwise = HeadsetTrouble::Failed);

/// Calls that a runtime refused although nothing was lost. The connection goes on without their effect.
class RefusedCalls {
 public:
  /// True if the call has succeeded; else the call is noted. Throws HeadsetFailure if the session or the runtime is
  /// lost.
  bool accept(XrResult result, const char* call);
  /// The first refused call and its result; empty: none.
  const std::string& first() const { return first_; }

 private:
  std::string first_;
};

}  // namespace glissade
