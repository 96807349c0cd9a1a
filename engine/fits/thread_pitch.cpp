#include "engine/fits/thread_pitch.h"

#include <algorithm>
#include <cmath>

#include "engine/evidence/pulled_thread.h"
#include "engine/geometry/thread_standards.h"

namespace glissade {
namespace {

/// Relative deviation from the nominal diameter within which a thread has this size.
constexpr double kNominalShare = 0.04;

/// Shares of the shaft's radius, and of the coarse pitch: a smaller excess is pressed in.
constexpr double kLeastDepth = 0.02;
constexpr double kLeastDepthInPitches = 0.13;

}  // namespace

ThreadPitch coarsePitch(double radius) {
  const ThreadSize& size = usualThreadSize(2.0 * radius);
  return {size.pitch, size.name};
}

std::string nominalSize(double diameter) {
  const ThreadSize& nearest = nearestThreadSize(ThreadFamily::Metric, diameter);
  const bool isNominal = std::abs(diameter - nearest.diameter) <= kNominalShare * nearest.diameter;
  return isNominal ? nearest.name : std::string();
}

double pitchOfDepth(double radius, double depth) {
  const double pitch = pitchOfCore(2.0 * radius, depth);
  return pitch > 0.0 ? pitch : coarsePitch(radius).pitch;
}

double pitchOfHole(double radius, double hole) {
  const double pitch = pitchOfCore(2.0 * radius, radius - hole);
  return pitch > 0.0 && isCoreByStandard(pitch, radius - hole) ? pitch : coarsePitch(radius).pitch;
}

bool isThreadDepth(double radius, double depth) {
  const double inPitches = kLeastDepthInPitches * coarsePitch(radius).pitch;
  return (depth > kLeastDepth * radius && depth > std::min(inPitches, evidence::kLeastThreadDepth * radius)) ||
         evidence::isCoreOfThread(radius, depth);
}

}  // namespace glissade
