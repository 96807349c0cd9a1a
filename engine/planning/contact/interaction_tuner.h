#pragma once

#include <cstdint>

#include "engine/planning/contact/interaction_settings.h"
#include "engine/planning/contact/step_median.h"
#include "engine/planning/roadmap.h"

namespace glissade {

/// What one planner step brought while somebody held the object.
struct StepOutcome {
  Author author = Author::Computer;  ///< whose configuration was tried
  bool grew = false;                 ///< a node or an edge was added
  double clearance = 0.0;            ///< of a contact sample: of the hand when contact mode was entered, metres
};

/// Sets alpha, N and d of Algorithm 1 by what computer, operator and contact have earned lately: the
/// first paper's future work. A sampler's yield is the share of its last hundred or so configurations
/// that grew the roadmap.
///
///   alpha = yield of the computer ^ 3/2   where it hardly gets on, a person has to lead
///   N = kNodesPerContact / yield of contact   contact mode is to bring that many nodes
///   d = kReach * clearance of the hand where contact samples grew the roadmap
///
/// all between bounds, because both extremes fail (paper 1, table V), and set anew every kWindow
/// steps. A pure value: no clock, no randomness; the same outcomes give the same settings, bit by bit.
class InteractionTuner {
 public:
  explicit InteractionTuner(double objectRadius);

  void observe(const StepOutcome& outcome);
  const InteractionSettings& settings() const { return settings_; }
  TuningReport report() const;

  static constexpr std::uint64_t kWindow = 40;  ///< steps: a second at the paper's pace
  static constexpr double kMemory = 100.0;      ///< configurations of one sampler
  static constexpr double kNodesPerContact = 8.0;
  static constexpr double kReach = 2.5;  ///< above 2, so that d can grow
  static constexpr double kLeastAlpha = 0.1;
  static constexpr double kMostAlpha = 0.9;
  static constexpr int kLeastSamples = 3;
  static constexpr int kMostSamples = 60;
  static constexpr double kLeastDistance = 0.04;  ///< times the object's radius
  static constexpr double kMostDistance = 0.12;

 private:
  void tune();

  double radius_;
  // Between what was measured on environments 1 and 2, so that a run begins with settings that do on both.
  double computerYield_ = 0.75;
  double contactYield_ = 0.4;
  double contactClearance_;  ///< of the hand where contact samples grew the roadmap, metres
  std::uint64_t steps_ = 0;
  InteractionSettings settings_;
  StepMedian alphaMedian_;  ///< in steps of 1 / kAlphaSteps
  StepMedian samplesMedian_;
  StepMedian distanceMedian_;  ///< in steps of the radius / kDistanceSteps
};

}  // namespace glissade
