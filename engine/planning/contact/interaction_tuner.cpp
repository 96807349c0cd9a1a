#include "engine/planning/contact/interaction_tuner.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

// Settings lie on grids, so that sliders do not flicker and rounding on a platform does not matter.
constexpr double kAlphaSteps = 100.0;      ///< grid from 0 to 1
constexpr double kDistanceSteps = 1000.0;  ///< grid from 0 to the object's radius

/// The grid step nearest to a value that is clamped to the bounds.
std::size_t stepOf(double value, double least, double most, double steps) {
  return static_cast<std::size_t>(std::lround(std::clamp(value, least, most) * steps));
}

/// Updates a mean in which older values lose weight.
void blend(double& mean, double value) { mean += (value - mean) / InteractionTuner::kMemory; }

}  // namespace

InteractionTuner::InteractionTuner(double objectRadius)
    : radius_(objectRadius),
      contactClearance_(0.02 * objectRadius),
      alphaMedian_(stepOf(kMostAlpha, 0.0, 1.0, kAlphaSteps)),
      samplesMedian_(kMostSamples),
      distanceMedian_(stepOf(kMostDistance, 0.0, 1.0, kDistanceSteps)) {
  tune();
}

void InteractionTuner::observe(const StepOutcome& outcome) {
  const double newGround = outcome.reach >= kNewGround * radius_ ? 1.0 : 0.0;
  switch (outcome.author) {
    case Author::Computer: blend(computerGround_, newGround); break;
    case Author::Operator: blend(operatorGround_, newGround); break;
    case Author::Contact:
      blend(contactYield_, outcome.reach > 0.0 ? 1.0 : 0.0);
      if (outcome.reach > 0.0) blend(contactClearance_, outcome.clearance);
      break;
  }
  alphaMedian_.add(stepOf(settings_.alpha, 0.0, 1.0, kAlphaSteps));
  samplesMedian_.add(static_cast<std::size_t>(settings_.contactSamples));
  distanceMedian_.add(stepOf(settings_.contactDistance / radius_, 0.0, 1.0, kDistanceSteps));
  if (++steps_ % kWindow == 0) tune();
}

void InteractionTuner::tune() {
  const double alpha = computerGround_ / (computerGround_ + operatorGround_ + kTrust);
  settings_.alpha = static_cast<double>(stepOf(alpha, kLeastAlpha, kMostAlpha, kAlphaSteps)) / kAlphaSteps;
  const double samples = kNodesPerContact / std::max(contactYield_, kNodesPerContact / kMostSamples);
  settings_.contactSamples = static_cast<int>(stepOf(samples, kLeastSamples, kMostSamples, 1.0));
  const double distance = kReach * contactClearance_ / radius_;
  settings_.contactDistance =
      radius_ * static_cast<double>(stepOf(distance, kLeastDistance, kMostDistance, kDistanceSteps)) / kDistanceSteps;
}

TuningReport InteractionTuner::report() const {
  TuningReport report;
  report.now = settings_;
  report.median.alpha = static_cast<double>(alphaMedian_.value()) / kAlphaSteps;
  report.median.contactSamples = static_cast<int>(samplesMedian_.value());
  report.median.contactDistance = radius_ * static_cast<double>(distanceMedian_.value()) / kDistanceSteps;
  return report;
}

}  // namespace glissade
