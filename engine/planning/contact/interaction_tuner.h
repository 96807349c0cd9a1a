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

/// What one planner step brought while somebody held the object.
struct StepOutcome {
  Author author = Author::Computer;  ///< whose configuration was tried
  double reach = 0.0;                ///< the longest edge that was added, metres in the metric; 0 where nothing was
  double clearance = 0.0;            ///< of a contact sample: of the hand when contact mode was entered, metres
};

/// Sets alpha, N and d of Algorithm 1 by what computer, operator and contact have earned lately: the
/// first paper's future work. Each is judged by its last hundred or so configurations.
///
///   alpha = C / (C + O + kTrust)   C, O: shares of the computer's and of the operator's own
///                                  configurations that broke new ground, kNewGround of the radius or more
///   N = kNodesPerContact / yield of contact   contact mode is to bring that many nodes
///   d = kReach * clearance of the hand where contact samples grew the roadmap
///
/// all between bounds, because both extremes fail (paper 1, table V), and set anew every kWindow
/// steps. Draws are shared in proportion to what they bring (matching). Ground, not growth: a hand that
/// moves a centimetre a step grows the roadmap each time and tells it nothing. The measure balances
/// itself: the fewer draws he has, the farther the hand has gone between two of them. A hand that waits in
/// a blocked passage brings nothing either, however little the computer earns there; draws are then
/// better spent on the computer and, when the hand comes near a surface, on contact, which O leaves out:
/// its share is N's. kTrust is what he is credited with unseen, because the ground behind a passage
/// that he shows is broken by others' configurations: without it alpha is at its bound there.
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
  static constexpr double kLeastDistance = 0.04;  ///< times the object's radius
  static constexpr double kMostDistance = 0.06;

 private:
  void tune();

  double radius_;
  // Between what was measured on environments 1 and 2, so that a run begins with settings that do on both.
  double computerGround_ = 0.6;
  double operatorGround_ = 0.2;
  double contactYield_ = 0.4;  ///< share that grew the roadmap at all
  double contactClearance_;    ///< of the hand where contact samples grew the roadmap, metres
  std::uint64_t steps_ = 0;
  InteractionSettings settings_;
  StepMedian alphaMedian_;  ///< in steps of 1 / kAlphaSteps
  StepMedian samplesMedian_;
  StepMedian distanceMedian_;  ///< in steps of the radius / kDistanceSteps
};

}  // namespace glissade
