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
/// Depths of drawn threads, in pitches: from a hole of the tap drill to the core of the shaft.
constexpr double kShallowest = 0.48;
constexpr double kDeepest = 0.63;

}  // namespace

ThreadPitch isoCoarsePitch(double radius) {
  const ThreadSize& nearest = nearestThreadSize(ThreadFamily::Metric, 2.0 * radius);
  return {nearest.pitch, nearest.name};
}

std::string nominalSize(double diameter) {
  const ThreadSize& nearest = nearestThreadSize(ThreadFamily::Metric, diameter);
  const bool isNominal = std::abs(diameter - nearest.diameter) <= kNominalShare * nearest.diameter;
  return isNominal ? nearest.name : std::string();
}

double pitchOfDepth(double radius, double depth) {
  const ThreadSize& nearest = nearestThreadSize(ThreadFamily::Metric, 2.0 * radius);
  const auto isOf = [&](double pitch) { return depth >= kShallowest * pitch && depth <= kDeepest * pitch; };
  if (isOf(nearest.pitch)) return nearest.pitch;
  const auto fine = std::find_if(nearest.finePitches.begin(), nearest.finePitches.end(), isOf);
  return fine == nearest.finePitches.end() ? nearest.pitch : *fine;
}

bool isThreadDepth(double radius, double depth) {
  const double inPitches = kLeastDepthInPitches * isoCoarsePitch(radius).pitch;
  return depth > kLeastDepth * radius && depth > std::min(inPitches, evidence::kLeastThreadDepth * radius);
}

}  // namespace glissade
