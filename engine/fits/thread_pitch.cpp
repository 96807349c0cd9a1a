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

/// Relative deviation of a shaft that is drawn with the outer diameter of its thread.
constexpr double kExactly = 0.003;

bool isExactly(const ThreadSize& size, double diameter) {
  return std::abs(diameter - size.diameter) <= kExactly * size.diameter;
}

}  // namespace

ThreadPitch coarsePitch(double radius) {
  const double diameter = 2.0 * radius;
  const ThreadSize& metric = nearestThreadSize(ThreadFamily::Metric, diameter);
  const ThreadSize& inch = nearestThreadSize(ThreadFamily::Unified, diameter);
  const bool isInch = inch.pitch > 0.0 && isExactly(inch, diameter) && !isExactly(metric, diameter);
  const ThreadSize& nearest = isInch ? inch : metric;
  return {nearest.pitch, nearest.name};
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
