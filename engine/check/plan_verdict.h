#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/check/condition.h"
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
  std::vector<Condition> conditions{};  ///< that the verdict on the step rests on
  std::vector<std::string> notes{};     ///< of rules that it says it does not keep, for people

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
  std::string group{};                  ///< number of the step that it belongs to, as stepNumber() has it

  bool valid() const;
  bool refused() const;  ///< as of StepVerdict
};

/// "3", "3.1": numbers count from the last step of the file, which is the first one of assembly, as in documents and in
/// the window. `index`: of the step in its list of so many steps. `group`: number of the step that the list belongs to.
std::string stepNumber(std::size_t index, std::size_t steps, const std::string& group = {});

/// The outcome of a verdict on a plan.
enum class PlanOutcome {
  Valid,        ///< every part leaves alone or in a unit, and all of it is shown
  Conditional,  ///< only under conditions that the plan states itself
  Incomplete,   ///< what the plan has is shown, and parts have no step, or leave in a group that is not taken apart
  Undecided,
  Invalid
};

/// What is said of a plan.
struct PlanVerdict {
  std::vector<StepVerdict> steps;
  std::vector<std::string> refusals{};  ///< of what the plan states of itself, for people
  std::size_t parts = 0;                ///< bodies that are to leave
  std::size_t remaining = 0;            ///< of them without a step
  std::size_t alone = 0;                ///< of those with a step: they leave alone, or are taken off their group
  std::size_t asUnits = 0;              ///< they leave with others that are handled as one
  std::size_t inGroups = 0;             ///< they leave in a group that is not taken apart
  double deviation = 0.0;               ///< metres that two surfaces may be nearer than their triangles
  std::vector<LineVerdict> lines{};     ///< those above before those below
  std::vector<Condition> conditions{};  ///< of the plan as a whole; those of steps are theirs
  bool planIsTrusted = false;           ///< a person confirms what the plan states

  std::size_t validSteps() const;                ///< of the plan's own
  std::size_t stepsWithoutProof() const;         ///< of flexible bodies, those of lines too
  std::vector<Condition> allConditions() const;  ///< each once, one for all clashes
  bool valid() const;                            ///< nothing is wrong with any step, nor with what the plan states
  bool refused() const;                          ///< as of StepVerdict
  PlanOutcome outcome() const;
};

/// Judges every step, those of lines too, each of its bodies along the common motion: against all bodies but those of
/// steps that have to be carried out before, so that every order that keeps Step::after is judged. Steps are judged by
/// all cores. Bodies have their frames in the middle of their boxes. `required`: clearance, metres; nothing: the usual
/// one for the size of each body. After a stop, steps are undecided.
PlanVerdict judgePlan(const Product& product, const Plan& plan, std::optional<double> required,
                      const WorkWatch& watch = {});

/// What of a plan's claims does not agree with its steps and the product, for people. `apart`: bodies that leave alone
/// or in what the plan says is a unit.
std::vector<std::string> wrongClaims(const Product& product, const Plan& plan, std::size_t apart);

}  // namespace glissade::check
