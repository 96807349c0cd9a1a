#pragma once

#include <openxr/openxr.h>

#include <stdexcept>
#include <string>

#include "widgets/headset/headset_machine.h"

namespace glissade {

/// Thrown by whatever speaks with the runtime; caught in one place of the headset's thread. The text is the detail.
class HeadsetFailure : public std::runtime_error {
 public:
  HeadsetFailure(HeadsetTrouble trouble, const std::string& detail) : std::runtime_error(detail), trouble_(trouble) {}
  HeadsetTrouble trouble() const { return trouble_; }

 private:
  HeadsetTrouble trouble_;
};

/// Throws where `call` has failed. What is not known by its result is this trouble.
void checkXr(XrResult result, const char* call, HeadsetTrouble otherwise = HeadsetTrouble::Failed);

}  // namespace glissade
