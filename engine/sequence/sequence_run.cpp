#include "engine/sequence/sequence_run.h"

#include <algorithm>
#include <optional>

#include "engine/fits/joint_edits.h"
#include "engine/fits/joint_finder.h"
#include "engine/sequence/demanding_trial.h"
#include "engine/sequence/fasteners.h"
#include "engine/sequence/isolated_bodies.h"
#include "engine/sequence/joined_units.h"
#include "engine/sequence/joint_rules.h"
#include "engine/sequence/motion_trial.h"
#include "engine/sequence/plan_steps.h"
#include "engine/sequence/standing.h"
#include "engine/sequence/step_joints.h"
#include "engine/sequence/step_precedence.h"
#include "engine/sequence/step_stacks.h"
#include "engine/sequence/step_tools.h"
#include "engine/sequence/subassembly_lines.h"
#include "engine/sequence/thread_demands.h"
#include "engine/sequence/work_position.h"

namespace glissade {
namespace {

/// The kinds by shape and contacts; a kind that a person states overrides them.
std::vector<FastenerKind> fastenersKnown(const ProductShapes& shapes, const std::vector<Contact>& contacts,
                                         const SequenceDemands& demands) {
  std::vector<FastenerKind> kinds = fastenersOf(shapes, contacts);
  for (const auto& [name, text] : demands.fasteners) {
    const auto kind = kFastenerNames.find(text);
    for (const std::size_t body : bodiesNamed(shapes.product(), name)) kinds[body] = kind.value_or(kinds[body]);
  }
  return kinds;
}

std::vector<bool> fragileBodies(const AssembledProduct& product, const SequenceDemands& demands) {
  std::vector<bool> fragile(product.bodies.size(), false);
  for (const std::string& name : demands.fragile) {
    for (const std::size_t body : bodiesNamed(product, name)) fragile[body] = true;
  }
  return fragile;
}

/// A body that stays may not have a demanded place.
Outcome checkPlaces(const AssembledProduct& product, const OrderRules& rules, const BodySet& staying) {
  for (const auto& step : rules.placed) {
    for (const std::size_t body : step.group) {
      if (!staying[body]) continue;
      return Diagnostic{ErrorKind::Usage,
                        "",
                        "",
                        {GLISSADE_TEXT("'%1' is fixed as base, and a constraint gives it a place among the steps"),
                         {product.bodies[body].id.text()}},
                        GLISSADE_TEXT("Fix another body as base, or remove the constraint.")};
    }
  }
  return Done{};
}

/// The joints that count: the given ones, else those that are found, with a person's edits; and joints for the threads
/// that the judge sees.
Result<Joints> jointsOf(const ProductShapes& shapes, const SequenceRequest& request, const ThreadDemands& threads,
                        const StopToken& stop) {
  const JointUse use = request.demands.jointUse;
  if (use == JointUse::Off) return Joints();
  if (request.joints != nullptr) return threads.withThreads(countingJoints(*request.joints, use), shapes);
  auto joints = applied(findJoints(shapes, stop), request.demands.joints, shapes.product());
  if (!joints) return joints;
  return threads.withThreads(countingJoints(*joints, use), shapes);
}

/// The base and the upward direction, as far as a person does not state them.
WorkPosition positionOf(const AssembledProduct& product, const LiaisonGraph& liaisons, const SequenceRequest& request,
                        const JointRules& joints, const std::vector<FastenerKind>& fasteners) {
  PositionQuestion question{product,        liaisons, joints.joints(), fasteners, BodySet(product.bodies.size(), true),
                            request.staying};
  if (request.demands.gravity) question.up = -*request.demands.gravity;
  return workPosition(question);
}

/// The bodies that a person fixes as base; else the base that suits.
BodySet fixedBodies(const SequenceRequest& request, const WorkPosition& position) {
  BodySet fixed = request.staying;
  if (std::find(fixed.begin(), fixed.end(), true) == fixed.end()) fixed[position.base] = true;
  return fixed;
}

/// Adds the demands to each announced plan, so that it can be saved and resumed.
class SavableHost final : public SequenceHost {
 public:
  SavableHost(const SequenceRequest& request, SequenceHost& host) : request_(request), host_(host) {}

  const StopToken& stopToken() const override { return host_.stopToken(); }
  ThreadTeam& team() override { return host_.team(); }
  void asking(const std::vector<BodyGroup>& groups, int effort) override { host_.asking(groups, effort); }
  void stepFound(const AssemblyPlan& plan) override {
    AssemblyPlan savable = plan;
    savable.strategy = request_.strategy;
    savable.demands = request_.demands;
    demandAllEarlier(savable);
    host_.stepFound(savable);
  }

 private:
  const SequenceRequest& request_;
  SequenceHost& host_;
};

/// Calls `answer` with the question of the request. `resumed`: see SequenceQuestion::resumed.
template <class Answer>
Outcome ask(const AssembledProduct& product, const ProductFits& fits, const SequenceRequest& request,
            const AssemblyPlan* resumed, SequenceHost& host, const Answer& answer) {
  auto rules = resolved(request.demands, product);
  if (!rules) return rules.error();
  const ProductShapes shapes(product);
  const std::vector<FastenerKind> fasteners = fastenersKnown(shapes, fits.contacts(), request.demands);
  const ThreadDemands threads(product, fits, request.demands, host.stopToken());
  auto found = jointsOf(shapes, request, threads, host.stopToken());
  if (!found) return found.error();
  const JointRules joints(std::move(*found), product, fasteners);
  const LiaisonGraph liaisons(product.bodies.size(), fits.contacts(), joints.joints());
  const WorkPosition position = positionOf(product, liaisons, request, joints, fasteners);
  const BodySet staying = withJoined(fixedBodies(request, position), joints.bonded());
  joinUnits(joints.bonded(), product, *rules);
  const Outcome places = checkPlaces(product, *rules, staying);
  if (!places) return places.error();
  const auto cost = StepCost::of(request.demands);
  if (!cost) return cost.error();
  const auto tools = chooseTools(shapes, fasteners, joints.joints(), request.demands);
  if (!tools) return tools.error();
  for (const OrderRule& rule : fastenerRules(fasteners, fits.contacts())) rules->before.push_back(rule);
  Standing standing(product,
                    {fits.contacts(), fasteners, staying, densitiesOf(request.demands, product), -position.up,
                     massesOf(request.demands, product)},
                    host.team());
  const JointRules* counting = joints.joints().empty() ? nullptr : &joints;
  MotionTrial motions(product, fits, request.seed, MotionTrial::kMostSearches, rules->forbidden, counting, &threads,
                      position.up);
  DemandingTrial trial(motions, *rules, product, request.known, counting);
  answer(SequenceQuestion{product,
                          staying,
                          request.seed,
                          trial,
                          resumed,
                          *rules,
                          fasteners,
                          &standing,
                          fragileBodies(product, request.demands),
                          *tools,
                          &*cost,
                          counting,
                          {},
                          &fits,
                          &liaisons,
                          isolatedBodies(product, liaisons),
                          position.up});
  return Done{};
}

/// Adds the request's demands to the plan, with the bends of the joints that it used.
void addDemands(AssemblyPlan& plan, const SequenceRequest& request, const SequenceQuestion& question) {
  plan.demands = request.demands;
  const Joints none;
  const Joints& joints = question.joints != nullptr ? question.joints->joints() : none;
  plan.demands.joints = withBends(plan.demands.joints, joints, question.product);
}

}  // namespace

Result<AssemblyPlan> planSequence(const AssembledProduct& product, const ProductFits& fits,
                                  const SequenceRequest& request, SequenceHost& host) {
  const SequenceStrategyRegistry registry = makeSequenceStrategyRegistry();
  const SequenceStrategyEntry* strategy = registry.find(request.strategy);
  if (strategy == nullptr) {
    return Diagnostic{ErrorKind::Usage,
                      "",
                      "strategy",
                      {GLISSADE_TEXT("is unknown: %1"), {request.strategy}},
                      GLISSADE_TEXT("Choose greedy or best-first.")};
  }
  std::optional<AssemblyPlan> resumed;
  if (request.resumed != nullptr) resumed = splitStacks(*request.resumed);
  AssemblyPlan plan;
  const Outcome asked = ask(product, fits, request, resumed ? &*resumed : nullptr, host, [&](const auto& question) {
    SavableHost savable(request, host);
    plan = strategy->make()->plan(question, savable);
    // A plan in which every body stays takes nothing apart. The judge does not call it complete.
    if (plan.parts() == 0 && plan.end == PlanEnd::Complete) plan.end = PlanEnd::Stuck;
    plan.isolated = idsOf(question.isolated, product);
    addJoints(plan, question);
    addLines(plan, question, host);
    addTools(plan, question, host);
    if (!host.stopToken().stopRequested()) joinStacks(plan, question, host.stopToken());
    addDemands(plan, request, question);
  });
  if (!asked) return asked.error();
  return plan;
}

Result<std::variant<AssemblyPlan, OrderConflict>> planWithOrder(const AssembledProduct& product,
                                                                const ProductFits& fits, const SequenceRequest& request,
                                                                const std::vector<std::size_t>& order,
                                                                SequenceHost& host) {
  std::variant<AssemblyPlan, OrderConflict> answer;
  const Outcome asked = ask(product, fits, request, nullptr, host, [&](const auto& question) {
    answer = withOrder(*request.resumed, order, question, host);
    if (auto* plan = std::get_if<AssemblyPlan>(&answer)) addDemands(*plan, request, question);
  });
  if (!asked) return asked.error();
  if (host.stopToken().stopRequested())
    return Diagnostic{ErrorKind::Interrupted, "", "", GLISSADE_TEXT("the operation was stopped"), {}};
  return answer;
}

}  // namespace glissade
