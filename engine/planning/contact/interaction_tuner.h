#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/tolerances.h"
#include "engine/planning/contact/interaction_settings.h"
#include "engine/planning/roadmap.h"

namespace glissade {

/// The median, over steps, of a whole number from 0 to a small maximum. Its size does not grow.
class StepMedian {
 public:
  explicit StepMedian(std::size_t maximum) : steps_(maximum + 1, 0) {}

  /// One more step with this value. Precondition: at most the maximum.
  void add(std::size_t value) {
    ++steps_[value];
    ++total_;
  }
  /// The lower one of two in the middle; 0 where nothing was added.
  std::size_t value() const {
    std::size_t value = 0;
    for (std::uint64_t below = steps_[0]; 2 * below < total_; below += steps_[value]) ++value;
    return value;
  }

 private:
  std::vector<std::uint64_t> steps_;  ///< by value
  std::uint64_t total_ = 0;
};

/// Outcome of one planner step while a person held the object.
struct StepOutcome {
  Author author = Author::Computer;  ///< author of the configuration that was tried
  double reach = 0.0;                ///< length of the longest added edge, metres in the metric; 0 if none was added
  double clearance = 0.0;  ///< clearance of the hand when contact mode was entered, for a contact sample, metres
};

/// Sets alpha, N and d of Algorithm 1 by the recent success of computer, operator and contact. Paper 1 names this as
/// future work. Each author is judged by about its last hundred configurations.
///
///   alpha = C / (C + O + kTrust)   C, O: shares of the computer's and of the operator's own
///                                  configurations that broke new ground, kNewGround of the radius or more
///   N = kNodesPerContact / yield of contact   contact mode is to bring that many nodes
///   d = kReach * clearance of the hand where contact samples grew the roadmap
///
/// All are clamped to bounds, because both extremes fail (paper 1, table V), and set anew every kWindow steps. Draws
/// are shared in proportion to their success (matching). The measure is new ground, not growth: a hand that moves a
/// centimetre a step grows the roadmap each time and adds no information. The measure balances itself: the fewer draws
/// the operator has, the farther the hand moves between two of them. A hand that waits in a blocked passage breaks no
/// new ground either, however little the computer's draws achieve there. Draws are then better spent on the computer
/// and, when the hand comes near a surface, on contact. O leaves contact samples out, because N sets their share.
/// kTrust is a fixed credit for the operator, because other authors' configurations break the ground behind a passage
/// that the operator shows. Without it alpha would lie at its bound there.
///
/// A pure value: no clock, no randomness; the same outcomes give the same settings, bit by bit.
class InteractionTuner {
 public:
  explicit InteractionTuner(double objectRadius);

  void observe(const StepOutcome& outcome);
  const InteractionSettings& settings() const { return settings_; }
  TuningReport report() const;

  static constexpr std::uint64_t kWindow = 40;  ///< steps: a second at the paper's pace
  static constexpr double kMemory = 100.0;      ///< configurations of one sampler
  static constexpr double kNewGround = tolerance::kRandomExtensionStep;
  static constexpr double kTrust = 0.2;  ///< one configuration in five
  static constexpr double kNodesPerContact = 13.0;
  static constexpr double kReach = 2.5;  ///< above 2, so that d can grow
  static constexpr double kLeastAlpha = 0.1;
  static constexpr double kMostAlpha = 0.9;
  static constexpr int kLeastSamples = 3;
  static constexpr int kMostSamples = 60;
  static constexpr double kLeastDistance = 0.04;  ///< in radii of the object
  static constexpr double kMostDistance = 0.06;

 private:
  void tune();

  double radius_;
  // Values between those measured on environments 1 and 2, so that the settings at the beginning of a run suit both.
  double computerGround_ = 0.6;
  double operatorGround_ = 0.2;
  double contactYield_ = 0.4;  ///< share of the contact samples that grew the roadmap
  double contactClearance_;    ///< clearance of the hand where contact samples grew the roadmap, metres
  std::uint64_t steps_ = 0;
  InteractionSettings settings_;
  StepMedian alphaMedian_;  ///< median in steps of 1 / kAlphaSteps
  StepMedian samplesMedian_;
  StepMedian distanceMedian_;  ///< median in steps of the radius / kDistanceSteps
};

}  // namespace glissade
