#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/check/motion_setup.h"
#include "engine/check/plan.h"

namespace glissade::check {

/// What is said of a step.
struct StepVerdict {
  std::vector<std::string> bodies;  ///< ids
  JudgedMotion motion{};            ///< names bodies by their number in the product; of a group the least clear one
  bool endsOutside = false;         ///< it ends clear of the bounding box of the others
  std::string againstDemand{};      ///< what a person demands and it does not keep; empty: nothing
  std::vector<AppliedAllowance> allowances{};
  std::vector<std::string> refusals{};  ///< of what it states, for people
  bool isFlexible = false;              ///< of a flexible body: nothing is said of its motion
  /// Threads that it pulls although they are drawn as threads, and why it may, for people.
  std::vector<std::string> pulls{};

  bool certified() const { return motion.verdict.status == Status::Certified; }
  bool valid() const { return (certified() || isFlexible) && endsOutside && againstDemand.empty() && refusals.empty(); }
  /// Shown to be wrong; neither valid nor refused: undecided.
  bool refused() const {
    const bool endsInside = certified() && !endsOutside;
    return motion.verdict.status == Status::Violated || endsInside || !againstDemand.empty() || !refusals.empty();
  }
};

/// What is said of a group that has left and is taken apart.
struct LineVerdict {
  std::vector<std::size_t> line{};  ///< numbers of the steps that lead to it, from 1: of the plan, of the line above…
  std::vector<StepVerdict> steps{};
  std::vector<std::string> refusals{};  ///< of what the line states of itself, for people

  bool valid() const;
  bool refused() const;  ///< as of StepVerdict
};

/// What is said of a plan: it is valid only where nothing is wrong with any step, nor with what it states of itself.
struct PlanVerdict {
  std::vector<StepVerdict> steps;
  std::vector<std::string> refusals{};  ///< of what the plan states of itself, for people
  std::size_t parts = 0;                ///< bodies that are to leave
  std::size_t remaining = 0;            ///< of them without a step
  double deviation = 0.0;               ///< metres that two surfaces may be nearer than their triangles
  std::vector<LineVerdict> lines{};     ///< those above before those below

  std::size_t validSteps() const;         ///< of the plan's own
  std::size_t stepsWithoutProof() const;  ///< of flexible bodies, those of lines too
  bool valid() const;
  bool refused() const;  ///< as of StepVerdict
};

/// Judges every step, those of lines too, each of its bodies along the common motion: against all bodies but those of
/// steps that have to be carried out before, so that every order that keeps Step::after is judged. Steps are judged by
/// all cores. Bodies have their frames in the middle of their boxes. `required`: clearance, metres; nothing: the usual
/// one for the size of each body. After a stop, steps are undecided.
PlanVerdict judgePlan(const Product& product, const Plan& plan, std::optional<double> required,
                      const WorkWatch& watch = {});

/// What of a plan's claims does not agree with its steps and the product, for people.
std::vector<std::string> wrongClaims(const Product& product, const Plan& plan);

}  // namespace glissade::check
