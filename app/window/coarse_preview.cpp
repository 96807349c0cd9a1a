#include "app/window/coarse_preview.h"

#include "engine/planning/coarse/milestones.h"
#include "engine/planning/fine/semantic_planner.h"

namespace glissade {
namespace {

SemanticEdits editsOf(const CoarsePlan& plan) { return plan.basis.edits ? *plan.basis.edits : SemanticEdits{}; }

/// Gives the steps of a preview their ends, as far as they are known, and their planners.
class Preview {
 public:
  Preview(const SemanticDocument& document, const Problem& problem, const ParsedRules& rules)
      : document_(document), problem_(problem), rules_(rules), query_(problem.world->makeQuery()) {}

  /// A plan of a run whose milestones hold.
  void keepMilestonesOf(const CoarsePlan& run) {
    for (const TopologicalStep& step : run.steps) {
      if (step.border < 0 || !step.milestone || edited(step.border, editsOf(run))) continue;
      drawn_[step.border] = step.to;
    }
  }

  void complete(CoarsePlan& plan) const {
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
      TopologicalStep& step = plan.steps[i];
      step.from = i == 0 ? problem_.start : plan.steps[i - 1].to;
      const Vector3& p_W = plan.graph->nodes[static_cast<std::size_t>(plan.nodes[i + 1])].p_W;
      const auto known = milestone(step.border);
      step.milestone = known.has_value();
      step.to = known ? *known : expected(step, i + 1 < plan.steps.size() ? &plan.steps[i + 1] : nullptr, p_W);
      const FineChoice choice = chooseFor(step, *document_.knowledge(), *document_.semantics(), rules_);
      step.planner = choice.local;
      step.geometrical = choice.geometrical;
      step.why = choice.why;
    }
  }

 private:
  std::optional<Pose> edited(int border, const SemanticEdits& edits) const {
    return editedMilestone(document_.knowledge()->environment->map, border, edits, *query_);
  }

  std::optional<Pose> milestone(int border) const {
    if (border < 0) return std::nullopt;
    if (const auto users = edited(border, document_.edits())) return users;
    const auto drawn = drawn_.find(border);
    return drawn != drawn_.end() ? std::make_optional(drawn->second) : std::nullopt;
  }

  /// Where a step whose milestone is not drawn yet will end, for choosing its planners.
  Pose expected(const TopologicalStep& step, const TopologicalStep* next, const Vector3& p_W) const {
    if (step.border < 0) return std::get<Pose>(problem_.goal);
    const auto fitted = rules_.fitted ? fittedMilestone(*document_.knowledge(), step, next) : std::nullopt;
    return fitted ? *fitted : Pose::translation(p_W);
  }

  const SemanticDocument& document_;
  const Problem& problem_;
  const ParsedRules& rules_;
  std::unique_ptr<CollisionQuery> query_;
  std::map<int, Pose> drawn_;  ///< by the run, per border
};

}  // namespace

bool isMultiLayer(const std::string& strategy) {
  const PlannerRegistry registry = makePlannerRegistry();
  const PlannerEntry* entry = registry.find(strategy);
  return entry != nullptr && entry->multiLayer;
}

bool isAboutPlaces(const CoarsePlan& plan, const SemanticDocument& document) {
  return !document.knowledge() || samePlaces(plan.basis.environment, document.knowledge()->environment);
}

bool isUpToDate(const CoarsePlan& plan, const SemanticDocument& document, const Problem& problem,
                const std::string& strategy) {
  return isMultiLayer(strategy) && plan.basis.rules == rulesOf(problem, strategy) && isAboutPlaces(plan, document) &&
         editsOf(plan) == document.edits();
}

Result<CoarsePlanPtr> previewPlan(const SemanticDocument& document, const Problem& problem, const std::string& strategy,
                                  const CoarsePlanPtr& run) {
  const SemanticModel* semantics = document.semantics();
  const Pose* goal = std::get_if<Pose>(&problem.goal);
  if (semantics == nullptr || goal == nullptr || !isMultiLayer(strategy)) return CoarsePlanPtr();
  const StrategyRules rules = rulesOf(problem, strategy);
  const auto parsed = parseRules(rules, semantics->table(), idsOf(makeLocalPlannerRegistry()));
  if (!parsed) return parsed.error();
  const EnvironmentModelPtr& environment = document.knowledge()->environment;
  auto plan = makeCoarsePlan(environment->map, *semantics, *parsed, problem.start.position, goal->position, {});
  if (!plan) return plan.error();
  plan->basis = {environment, std::make_shared<const SemanticEdits>(document.edits()), rules};
  Preview preview(document, problem, *parsed);
  if (run && run->basis.rules == rules && isAboutPlaces(*run, document)) preview.keepMilestonesOf(*run);
  preview.complete(*plan);
  return std::make_shared<const CoarsePlan>(std::move(*plan));
}

}  // namespace glissade
