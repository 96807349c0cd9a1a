#include "engine/planning/contact/interaction_tuner.h"

#include <algorithm>
#include <cmath>

namespace glissade {
namespace {

constexpr double kAlphaGrid = 0.01;
constexpr double kDistanceGrid = 0.001;  ///< times the object's radius

/// The point of a grid that a value between bounds is nearest to.
std::size_t onGrid(double value, double least, double most, double grid) {
  return static_cast<std::size_t>(std::lround(std::clamp(value, least, most) / grid));
}

/// A mean that forgets.
void blend(double& mean, double value) { mean += (value - mean) / InteractionTuner::kMemory; }

}  // namespace

InteractionTuner::InteractionTuner(double objectRadius)
    : radius_(objectRadius),
      contactClearance_(0.015 * objectRadius),
      alphaMedian_(onGrid(kMostAlpha, 0.0, 1.0, kAlphaGrid)),
      samplesMedian_(kMostSamples),
      distanceMedian_(onGrid(kMostDistance, 0.0, 1.0, kDistanceGrid)) {
  tune();
}

void InteractionTuner::observe(const StepOutcome& outcome) {
  const double grew = outcome.grew ? 1.0 : 0.0;
  if (outcome.author == Author::Computer) blend(computerYield_, grew);
  if (outcome.author == Author::Contact) {
    blend(contactYield_, grew);
    if (outcome.grew) blend(contactClearance_, outcome.clearance);
  }
  alphaMedian_.add(onGrid(settings_.alpha, 0.0, 1.0, kAlphaGrid));
  samplesMedian_.add(static_cast<std::size_t>(settings_.contactSamples));
  distanceMedian_.add(onGrid(settings_.contactDistance / radius_, 0.0, 1.0, kDistanceGrid));
  if (++steps_ % kWindow == 0) tune();
}

/// On grids, so that sliders are calm and a platform's rounding does not matter.
void InteractionTuner::tune() {
  const double alpha = computerYield_ * std::sqrt(computerYield_);
  settings_.alpha = kAlphaGrid * static_cast<double>(onGrid(alpha, kLeastAlpha, kMostAlpha, kAlphaGrid));
  const double samples = kNodesPerContact / std::max(contactYield_, kNodesPerContact / kMostSamples);
  settings_.contactSamples = static_cast<int>(onGrid(samples, kLeastSamples, kMostSamples, 1.0));
  const double distance = kReach * contactClearance_ / radius_;
  settings_.contactDistance =
      radius_ * kDistanceGrid * static_cast<double>(onGrid(distance, kLeastDistance, kMostDistance, kDistanceGrid));
}

TuningReport InteractionTuner::report() const {
  TuningReport report;
  report.now = settings_;
  report.median.alpha = kAlphaGrid * static_cast<double>(alphaMedian_.value());
  report.median.contactSamples = static_cast<int>(samplesMedian_.value());
  report.median.contactDistance = radius_ * kDistanceGrid * static_cast<double>(distanceMedian_.value());
  return report;
}

}  // namespace glissade
