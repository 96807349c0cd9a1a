#include "engine/planning/fine/coarse_preview.h"

#include "engine/planning/coarse/coarse_planning.h"
#include "engine/planning/fine/semantic_planner.h"
#include "engine/planning/goal_roots.h"
#include "engine/planning/planner.h"

namespace glissade {
namespace {

/// Sets the ends of the steps, where they are known, and their planners.
void complete(CoarsePlan& plan, const CoarsePlanning& coarse, const Problem& problem, CollisionQuery& query) {
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    TopologicalStep& step = plan.steps[i];
    const TopologicalStep* next = i + 1 < plan.steps.size() ? &plan.steps[i + 1] : nullptr;
    step.from = i == 0 ? problem.start : plan.steps[i - 1].to;
    step.milestone = step.border >= 0 && coarse.decidedMilestone(step, query);
    const Vector3& p_W = plan.graph->nodes[static_cast<std::size_t>(plan.nodes[i + 1])].p_W;
    step.to = coarse.knownMilestone(step, next, query).value_or(Pose::translation(p_W));
    const FineChoice choice = chooseFor(step, coarse.knowledge(), coarse.semantics(), coarse.rules());
    step.planner = choice.local;
    step.geometrical = choice.geometrical;
    step.why = choice.why;
  }
}

}  // namespace

bool isMultiLayer(const std::string& strategy) {
  const PlannerRegistry registry = makePlannerRegistry();
  const PlannerEntry* entry = registry.find(strategy);
  return entry != nullptr && entry->multiLayer;
}

bool isAboutPlaces(const CoarsePlan& plan, const SceneKnowledgePtr& knowledge) {
  return !knowledge || samePlaces(plan.basis.environment, knowledge->environment);
}

bool isUpToDate(const CoarsePlan& plan, const PreviewQuestion& question) {
  const auto editsOf = [](const SemanticEditsPtr& edits) { return edits ? *edits : SemanticEdits{}; };
  return isMultiLayer(question.strategy) && plan.basis.rules == rulesOf(question.problem, question.strategy) &&
         isAboutPlaces(plan, question.knowledge) && editsOf(plan.basis.edits) == editsOf(question.edits);
}

Result<CoarsePlanPtr> previewPlan(const PreviewQuestion& question) {
  const Problem& problem = question.problem;
  if (!question.knowledge || !isMultiLayer(question.strategy)) return CoarsePlanPtr();
  const auto query = problem.world->makeQuery();
  const std::vector<Pose> goals = goalRoots(problem, *query);
  if (goals.empty()) return CoarsePlanPtr();
  const StrategyRules rules = rulesOf(problem, question.strategy);
  CoarsePlanning coarse(problem, goals.front(), question.knowledge, rules, question.edits);
  auto plan = coarse.plan({});
  if (!plan) return plan.error();
  if (question.run && question.run->basis.rules == rules && isAboutPlaces(*question.run, question.knowledge)) {
    coarse.keepMilestonesOf(*question.run, *query);
  }
  complete(*plan, coarse, problem, *query);
  return std::make_shared<const CoarsePlan>(std::move(*plan));
}

}  // namespace glissade
