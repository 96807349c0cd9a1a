#include "engine/planning/coarse/coarse_planning.h"

#include "engine/planning/planner.h"

namespace glissade {
namespace {

std::vector<MilestoneEdit> milestonesOf(const SemanticEditsPtr& edits) {
  return edits ? edits->milestones : std::vector<MilestoneEdit>{};
}

}  // namespace

CoarsePlanning::CoarsePlanning(const Problem& problem, const Pose& goal, SceneKnowledgePtr knowledge,
                               StrategyRules rules, SemanticEditsPtr edits)
    : problem_(problem),
      goal_(goal),
      knowledge_(std::move(knowledge)),
      rules_(std::move(rules)),
      edits_(std::move(edits)) {}

bool CoarsePlanning::setEdits(SemanticEditsPtr edits) {
  const bool others = milestonesOf(edits) != milestonesOf(edits_);
  edits_ = std::move(edits);
  semantics_.reset();
  parsed_.reset();  // an attribute that the rules name may be gone
  if (others) kept_.clear();
  return others;
}

Result<CoarsePlan> CoarsePlanning::plan(const LearntCosts& learnt) {
  if (!semantics_) semantics_.emplace(semanticsOf(problem_, *knowledge_, edits_));
  if (!parsed_) {
    auto parsed = parseRules(rules_, semantics_->table(), idsOf(makeLocalPlannerRegistry()));
    if (!parsed) return parsed.error();
    parsed_.emplace(std::move(*parsed));
  }
  auto made = makeCoarsePlan(map(), *semantics_, *parsed_, problem_.start.position, goal_.position, learnt);
  if (made) made->basis = {knowledge_->environment, edits_, rules_};
  return made;
}

void CoarsePlanning::forgetBlocked(CollisionQuery& query) {
  std::erase_if(kept_, [&](const auto& each) { return query.collides(each.second); });
}

void CoarsePlanning::keepMilestonesOf(const CoarsePlan& run, CollisionQuery& query) {
  const SemanticEdits edits = run.basis.edits ? *run.basis.edits : SemanticEdits{};
  for (const TopologicalStep& step : run.steps) {
    if (step.border < 0 || !step.milestone || editedMilestone(map(), step.border, edits, query)) continue;
    keep(step.border, step.to);
  }
}

std::optional<Pose> CoarsePlanning::decidedMilestone(const TopologicalStep& step, CollisionQuery& query) const {
  if (step.border < 0) return goal_;
  if (edits_) {
    if (const auto users = editedMilestone(map(), step.border, *edits_, query)) return users;
  }
  const auto kept = kept_.find(step.border);
  return kept != kept_.end() ? std::make_optional(kept->second) : std::nullopt;
}

std::optional<Pose> CoarsePlanning::knownMilestone(const TopologicalStep& step, const TopologicalStep* next,
                                                   CollisionQuery& query) const {
  if (const auto decided = decidedMilestone(step, query)) return decided;
  return parsed_->fitted ? fittedMilestone(*knowledge_, step, next) : std::nullopt;
}

}  // namespace glissade
