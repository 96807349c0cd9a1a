#include "engine/sequence/subassembly_lines.h"

#include <algorithm>

#include "engine/sequence/best_first_strategy.h"
#include "engine/sequence/forwarding_trial.h"
#include "engine/sequence/plan_steps.h"
#include "engine/sequence/step_joints.h"
#include "engine/sequence/step_stacks.h"
#include "engine/sequence/step_tools.h"
#include "engine/sequence/work_position.h"

namespace glissade {
namespace {

/// Limit of the efforts in lines: no search but the shortest one.
constexpr int kLineEfforts = 2;

/// Forwards to another trial, without its longer searches.
class ShortTrial final : public ForwardingTrial {
 public:
  using ForwardingTrial::ForwardingTrial;
  int efforts() const override { return std::min(kLineEfforts, ForwardingTrial::efforts()); }
};

/// Forwards to another host, except the plan so far: a line cannot be resumed.
class LineHost final : public SequenceHost {
 public:
  explicit LineHost(SequenceHost& host) : host_(host) {}
  const StopToken& stopToken() const override { return host_.stopToken(); }
  ThreadTeam& team() override { return host_.team(); }
  void asking(const std::vector<BodyGroup>& groups, int effort) override { host_.asking(groups, effort); }
  void stepFound(const AssemblyPlan& /*plan*/) override {}

 private:
  SequenceHost& host_;
};

/// The unit of the group that contains the body.
BodyGroup unitIn(std::size_t body, const JointRules* joints) {
  if (joints != nullptr) {
    for (const BodyGroup& unit : joints->bonded()) {
      if (std::binary_search(unit.begin(), unit.end(), body)) return unit;
    }
  }
  return {body};
}

/// The base of a group, and how the group lies on the bench.
WorkPosition positionIn(const BodySet& there, const SequenceQuestion& question) {
  const Joints none;
  const Joints& joints = question.joints == nullptr ? none : question.joints->joints();
  const auto by = [&](const LiaisonGraph& liaisons) {
    return workPosition({question.product, liaisons, joints, question.fasteners, there});
  };
  return question.liaisons != nullptr ? by(*question.liaisons) : by(LiaisonGraph(there.size(), {}, joints));
}

/// Demands on places and on groups that leave together concern the whole product, and do not hold in a line.
OrderRules rulesOf(const SequenceQuestion& question, const BodySet& there) {
  OrderRules rules = question.rules;
  rules.placed.clear();
  rules.motions.clear();
  rules.together.clear();
  if (question.joints == nullptr) return rules;
  for (const BodyGroup& unit : question.joints->bonded()) {
    if (there[unit.front()]) rules.together.push_back(unit);
  }
  return rules;
}

/// The question about a group. Support is not checked: a worker may hold a group in any pose.
SequenceQuestion questionOf(const BodyGroup& group, const SequenceQuestion& question, RemovalTrial& trial) {
  BodySet there(question.product.bodies.size(), false);
  BodySet staying = there;
  for (const std::size_t body : group) there[body] = true;
  const WorkPosition position = positionIn(there, question);
  for (const std::size_t body : unitIn(position.base, question.joints)) staying[body] = true;
  return {question.product,
          staying,
          question.seed,
          trial,
          nullptr,
          rulesOf(question, there),
          question.fasteners,
          nullptr,
          question.fragile,
          question.tools,
          question.cost,
          question.joints,
          there,
          question.fits,
          question.liaisons,
          {},
          position.up};
}

SubassemblyLine lineOf(const BodyGroup& group, const SequenceQuestion& question, RemovalTrial& trial,
                       SequenceHost& host);

/// The lines of groups among the steps that are no units. Marks the units.
std::vector<SubassemblyLine> linesOf(std::vector<AssemblyStep>& steps, const SequenceQuestion& question,
                                     RemovalTrial& trial, SequenceHost& host) {
  std::vector<SubassemblyLine> lines;
  for (std::size_t i = 0; i < steps.size() && !host.stopToken().stopRequested(); ++i) {
    const BodyGroup group = groupOf(steps[i], question.product);
    if (group.size() == 1) continue;
    StepMotion& motion = steps[i].only();
    motion.unit = unitIn(group.front(), question.joints).size() >= group.size();
    if (motion.unit) continue;
    lines.push_back(lineOf(group, question, trial, host));
    lines.back().step = i + 1;
  }
  return lines;
}

SubassemblyLine lineOf(const BodyGroup& group, const SequenceQuestion& question, RemovalTrial& trial,
                       SequenceHost& host) {
  const SequenceQuestion own = questionOf(group, question, trial);
  LineHost quiet(host);
  AssemblyPlan plan = BestFirstStrategy().plan(own, quiet);
  addJoints(plan, own);
  addTools(plan, own, quiet);
  plan.lines = linesOf(plan.steps, own, trial, quiet);
  joinStacks(plan, own, quiet.stopToken());
  SubassemblyLine line;
  line.bodies = idsOf(group, question.product);
  line.staying = std::move(plan.staying);
  line.up = own.up;
  line.lines = std::move(plan.lines);
  line.steps = std::move(plan.steps);
  line.stuck = std::move(plan.stuck);
  return line;
}

std::size_t apartIn(const std::vector<AssemblyStep>& steps, const std::vector<SubassemblyLine>& lines) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto line = std::find_if(lines.begin(), lines.end(), [&](const auto& each) { return each.step == i + 1; });
    if (line == lines.end()) {
      for (const StepMotion& motion : steps[i].motions) {
        const std::size_t bodies = 1 + motion.with.size();
        count += bodies == 1 || motion.unit ? bodies : 0;
      }
    } else {
      std::size_t left = 0;
      for (const AssemblyStep& step : line->steps) left += step.bodies().size();
      const bool isTakenApart = left + line->staying.size() == line->bodies.size();
      count += apartIn(line->steps, line->lines) + (isTakenApart ? line->staying.size() : 0);
    }
  }
  return count;
}

}  // namespace

std::size_t bodiesApart(const AssemblyPlan& plan) { return apartIn(plan.steps, plan.lines); }

void addLines(AssemblyPlan& plan, const SequenceQuestion& question, SequenceHost& host) {
  ShortTrial trial(question.trial);
  plan.lines = linesOf(plan.steps, question, trial, host);
}

}  // namespace glissade
