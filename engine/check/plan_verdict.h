#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/message.h"
#include "engine/base/thread_team.h"
#include "engine/base/work_watch.h"
#include "engine/check/condition.h"
#include "engine/check/motion_setup.h"
#include "engine/check/plan.h"
#include "engine/model/body_id.h"

namespace glissade::check {

/// The verdict on a motion of a step.
struct StepVerdict {
  std::vector<BodyId> bodies;  ///< ids
  JudgedMotion motion{};       ///< names bodies by number in the product; for a group, the least clear one
  bool endsOutside = false;    ///< each body ends clear of the bounding box of the others
  Message againstDemand{};     ///< demand of a person that the step breaks; empty: none
  std::vector<AppliedAllowance> allowances{};
  std::vector<Message> refusals{};  ///< refused statements of the step, for people
  bool isFlexible = false;          ///< the step is of a flexible body: its motion is not judged
  /// Threads that the step pulls although they are drawn as threads, and the reason why it may, for people.
  std::vector<Message> pulls{};
  std::vector<Condition> conditions{};  ///< conditions on which the verdict depends
  std::vector<Message> notes{};         ///< rules that the step says it breaks, for people
  std::size_t number = 1;               ///< see Step::number
  std::size_t motionNumber = 0;         ///< see Step::motion

  bool certified() const { return motion.verdict.status == Status::Certified; }
  bool valid() const { return (certified() || isFlexible) && endsOutside && againstDemand.empty() && refusals.empty(); }
  /// True if the step is shown to be wrong. A step that is neither valid nor refused is undecided.
  bool refused() const {
    const bool endsInside = certified() && !endsOutside;
    return motion.verdict.status == Status::Violated || endsInside || !againstDemand.empty() || !refusals.empty();
  }
};

/// The verdict on a group that has left and is taken apart.
struct LineVerdict {
  std::vector<std::size_t> line{};   ///< step numbers, from 1, on the way to it: in the plan, in the line above, ...
  std::vector<StepVerdict> steps{};  ///< one for each motion, in order
  std::vector<Message> refusals{};   ///< refused statements of the line, for people
  std::string group{};               ///< number of its step, see stepNumber()

  bool valid() const;
  bool refused() const;  ///< see StepVerdict::refused()
};

/// "3" or "3.1": numbers count from the last step of the file, which is the first one of assembly, as in documents and
/// in the window. `index`: of the step in its list of `steps` steps. `group`: number of the step to which the list
/// belongs.
std::string stepNumber(std::size_t index, std::size_t steps, const std::string& group = {});

/// The outcome of a verdict on a plan.
enum class PlanOutcome {
  Valid,        ///< every part leaves alone or in a unit, and all is proved
  Conditional,  ///< valid under conditions that the plan states itself
  Incomplete,   ///< all steps are proved, but parts have no step, or leave in a group that is not taken apart
  Undecided,
  Invalid
};

/// The number of steps of these motions.
std::size_t stepsIn(const std::vector<StepVerdict>& motions);

struct PlanVerdict {
  std::vector<StepVerdict> steps;       ///< one for each motion, in order
  std::vector<Message> refusals{};      ///< refused statements of the plan, for people
  std::size_t parts = 0;                ///< bodies that are to leave
  std::size_t remaining = 0;            ///< bodies without a step
  std::size_t alone = 0;                ///< bodies that leave alone, or are taken off their group
  std::size_t asUnits = 0;              ///< bodies that leave with others that are handled as one
  std::size_t inGroups = 0;             ///< bodies that leave in a group that is not taken apart
  double deviation = 0.0;               ///< metres by which two surfaces may be nearer than their triangles
  std::vector<LineVerdict> lines{};     ///< a line comes before the lines below it
  std::vector<Condition> conditions{};  ///< conditions of the plan as a whole; steps have conditions of their own
  bool planIsTrusted = false;           ///< a person confirms the plan's statements

  std::size_t validSteps() const;                ///< number of valid steps of the plan, without those of lines
  bool isValid(std::size_t step) const;          ///< all motions of the plan's step with this number are valid
  std::size_t stepsWithoutProof() const;         ///< number of steps of flexible bodies, including those of lines
  std::vector<Condition> allConditions() const;  ///< each condition once, and one for all clashes
  bool valid() const;                            ///< all steps and all statements of the plan are valid
  bool refused() const;                          ///< see StepVerdict::refused()
  PlanOutcome outcome() const;
};

/// Judges every motion of each step, including those of lines. Its bodies move along the common motion against all
/// bodies except those of the steps that have to come before and of the earlier motions of its step, so that every
/// order that keeps Step::after is judged. Motions are judged in `threads` threads, which do not change the verdict.
/// Bodies have their frames at the centres of their boxes. `required`: clearance, metres; nothing: the usual one for
/// the size of each body. After a stop, steps are undecided.
PlanVerdict judgePlan(const Product& product, const Plan& plan, std::optional<double> required,
                      const WorkWatch& watch = {}, std::size_t threads = usableCores());

/// Claims of a plan that contradict its steps or the product, for people. `apart`: number of bodies that leave alone or
/// in a unit by the plan's statement.
std::vector<Message> wrongClaims(const Product& product, const Plan& plan, std::size_t apart);

}  // namespace glissade::check
