#include "engine/sequence/step_stacks.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engine/sequence/plan_steps.h"
#include "engine/sequence/step_precedence.h"

namespace glissade {
namespace {

/// New numbers of steps that are joined or split.
class StepNumbers {
 public:
  /// The next old step becomes the new step with this number, from 1; the last one of several.
  void add(std::size_t number) { numbers_.push_back(number); }
  std::size_t of(std::size_t step) const { return numbers_[step - 1]; }
  /// The number of new steps that contain the first `count` old ones.
  std::size_t countOf(std::size_t count) const { return count == 0 ? 0 : of(count); }

 private:
  std::vector<std::size_t> numbers_;
};

/// Changes the numbers of steps that are carried out before searches.
void renumberSearches(AssemblyPlan& plan, const StepNumbers& numbers) {
  for (RefusedRemoval& refused : plan.refusals) refused.afterSteps = numbers.countOf(refused.afterSteps);
  for (StepMotion& motion : plan.waiting) motion.proof.afterSteps = numbers.countOf(motion.proof.afterSteps);
}

/// Waves and tasks count from 1 without gaps. A task of one step is none.
void renumberWavesAndTasks(std::vector<AssemblyStep>& steps) {
  std::map<std::size_t, std::size_t> stepsOfTask;
  for (const AssemblyStep& step : steps) ++stepsOfTask[step.task];
  std::map<std::size_t, std::size_t> tasks;
  std::size_t earlier = 0;
  std::size_t wave = 0;
  for (AssemblyStep& step : steps) {
    if (step.wave != earlier) ++wave;
    earlier = std::exchange(step.wave, wave);
    const bool isTask = step.task != 0 && stepsOfTask[step.task] > 1;
    step.task = isTask ? tasks.try_emplace(step.task, tasks.size() + 1).first->second : 0;
  }
}

/// Removes allowances against bodies that have left in every order: a step is after more steps than its motions were.
void dropAllowancesAgainstLeft(std::vector<AssemblyStep>& steps) {
  const std::vector<std::set<std::size_t>> before = allBefore(steps);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    std::set<BodyId> left;
    const auto leave = [&](const std::vector<BodyId>& bodies) { left.insert(bodies.begin(), bodies.end()); };
    for (const std::size_t number : before[i]) leave(steps[number - 1].bodies());
    for (StepMotion& motion : steps[i].motions) {
      std::erase_if(motion.allowances, [&](const Allowance& each) { return left.count(each.body) != 0; });
      leave(motion.bodies());
    }
  }
}

class StackJoiner {
 public:
  StackJoiner(const std::vector<AssemblyStep>& steps, const SequenceQuestion& question, const StopToken& stop)
      : steps_(steps), question_(question), stop_(stop), present_{question.initial()} {
    for (const AssemblyStep& step : steps) {
      BodyGroup group = groupOf(step, question.product);
      const bool continues = !groups_.empty() && continuesStack(group, groups_.back(), question.joints);
      if (!continues) ends_.push_back(groups_.size());
      numbers_.add(ends_.size());
      ends_.back() = groups_.size() + 1;
      present_.push_back(without(present_.back(), group));
      groups_.push_back(std::move(group));
    }
  }

  const StepNumbers& numbers() const { return numbers_; }

  /// Nothing if a motion is not certified again.
  std::optional<std::vector<AssemblyStep>> joined() {
    std::vector<AssemblyStep> joined(ends_.size());
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      auto motion = motionInStep(i);
      if (!motion) return std::nullopt;
      const std::size_t number = numbers_.of(i + 1);
      AssemblyStep& step = joined[number - 1];
      if (step.motions.empty()) std::tie(step.wave, step.task) = std::pair(steps_[i].wave, steps_[i].task);
      step.motions.push_back(std::move(*motion));
      step.violates.insert(step.violates.end(), steps_[i].violates.begin(), steps_[i].violates.end());
      std::set<std::size_t> after(step.after.begin(), step.after.end());
      for (const std::size_t earlier : steps_[i].after) after.insert(numbers_.of(earlier));
      after.erase(number);
      step.after.assign(after.begin(), after.end());
    }
    renumberWavesAndTasks(joined);
    dropAllowancesAgainstLeft(joined);
    return joined;
  }

 private:
  /// The motion of step `i` with the bodies that its proof claims in the joined step: those that remain after whole
  /// steps and the earlier motions of its own step.
  std::optional<StepMotion> motionInStep(std::size_t i) const {
    StepMotion motion = steps_[i].only();
    const std::size_t own = numbers_.of(i + 1);
    motion.proof.afterSteps = std::min(numbers_.countOf(motion.proof.afterSteps), own - 1);
    BodySet claimed = present_[motion.proof.afterSteps == 0 ? 0 : ends_[motion.proof.afterSteps - 1]];
    for (std::size_t earlier = own == 1 ? 0 : ends_[own - 2]; earlier < i; ++earlier) {
      claimed = without(std::move(claimed), groups_[earlier]);
    }
    const BodyId& nearest = motion.proof.nearest;
    if (nearest.empty() || claimed[question_.product.indexOf(nearest)]) return motion;
    const auto removed = question_.trial.certified(groups_[i], motion.path, motion.method, claimed, stop_);
    if (!removed) return std::nullopt;
    motion.proof = makeMotion(groups_[i], *removed, question_, claimed, motion.proof.afterSteps).proof;
    return motion;
  }

  const std::vector<AssemblyStep>& steps_;
  const SequenceQuestion& question_;
  const StopToken& stop_;
  std::vector<BodyGroup> groups_;  ///< of each motion
  std::vector<BodySet> present_;   ///< bodies that are there after the first n motions, for each n
  std::vector<std::size_t> ends_;  ///< for each joined step, the number of motions up to its end
  StepNumbers numbers_;
};

}  // namespace

bool continuesStack(const BodyGroup& group, const BodyGroup& before, const JointRules* joints) {
  if (joints == nullptr || group.size() != 1 || before.size() != 1) return false;
  const std::size_t stack = joints->stackOf(group.front());
  return stack != 0 && stack == joints->stackOf(before.front());
}

void joinStacks(AssemblyPlan& plan, const SequenceQuestion& question, const StopToken& stop) {
  StackJoiner joiner(plan.steps, question, stop);
  auto joined = joiner.joined();
  if (!joined) return;
  for (SubassemblyLine& line : plan.lines) line.step = joiner.numbers().of(line.step);
  renumberSearches(plan, joiner.numbers());
  plan.steps = std::move(*joined);
}

AssemblyPlan splitStacks(AssemblyPlan plan) {
  StepNumbers numbers;
  std::size_t count = 0;
  for (const AssemblyStep& step : plan.steps) numbers.add(count += step.motions.size());
  std::vector<AssemblyStep> split;
  for (AssemblyStep& step : plan.steps) {
    const std::size_t before = split.size();
    for (StepMotion& motion : step.motions) {
      const std::size_t after = numbers.countOf(motion.proof.afterSteps);
      motion.proof.afterSteps = after == before ? split.size() : after;
      split.push_back({{std::move(motion)}, step.wave, {}, step.violates, step.task});
    }
  }
  plan.steps = std::move(split);
  plan.lines.clear();
  renumberSearches(plan, numbers);
  return plan;
}

}  // namespace glissade
