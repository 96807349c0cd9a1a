#include "engine/evidence/thread.h"

#include <algorithm>
#include <cmath>

#include "engine/base/number_text.h"

namespace glissade::evidence {

Message wrongPitch(const Thread& thread) {
  const double diameter = 2.0 * std::max(thread.radiusMoving, thread.radiusOther);
  const double pitch = std::abs(thread.pitch);
  if (pitch >= kLeastThreadPitch && pitch <= kMostPitchInDiameters * diameter) return {};
  return {GLISSADE_TEXT("a pitch of %1 mm is none of a thread of %2 mm: it has to be from 0.01 mm to two diameters"),
          {shortText(pitch * 1e3), shortText(diameter * 1e3)}};
}

}  // namespace glissade::evidence
