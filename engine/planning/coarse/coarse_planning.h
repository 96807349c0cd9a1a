#pragma once

#include <map>

#include "engine/planning/coarse/milestones.h"
#include "engine/planning/coarse/topological_planner.h"

namespace glissade {

/// The coarse planning of one problem by one set of rules, and the milestones that are known. Runs and previews use
/// it alike. Not for several threads at once.
class CoarsePlanning {
 public:
  /// `goal`: of "out" the configuration that is planned for. `edits` null: none.
  CoarsePlanning(const Problem& problem, const Pose& goal, SceneKnowledgePtr knowledge, StrategyRules rules,
                 SemanticEditsPtr edits);

  /// Other edits from now on. Milestones that were kept are forgotten where the user's milestones have changed.
  /// Returns whether they were.
  bool setEdits(SemanticEditsPtr edits);
  /// The cheapest coarse path, with its basis; milestones are not drawn yet. Errors are those of the rules.
  Result<CoarsePlan> plan(const LearntCosts& learnt);

  /// Keeps the milestone of a border for the coarse paths to come.
  void keep(int border, const Pose& milestone) { kept_[border] = milestone; }
  void forget(int border) { kept_.erase(border); }
  /// Those that are not free any more, because a place was forbidden.
  void forgetBlocked(CollisionQuery& query);
  bool keeps(int border) const { return kept_.count(border) > 0; }
  /// Keeps what a run has drawn, where that was not the user's milestone.
  void keepMilestonesOf(const CoarsePlan& run, CollisionQuery& query);

  /// Where a step ends, as far as that is known without drawing: the goal; the user's milestone; the one that is kept.
  std::optional<Pose> decidedMilestone(const TopologicalStep& step, CollisionQuery& query) const;
  /// Besides, where the rules want it, the configuration that fits the passage best. `next`: the step after it, or
  /// null.
  std::optional<Pose> knownMilestone(const TopologicalStep& step, const TopologicalStep* next,
                                     CollisionQuery& query) const;

  const SceneKnowledge& knowledge() const { return *knowledge_; }
  /// Precondition of both: plan() has succeeded with these edits.
  const SemanticModel& semantics() const { return *semantics_; }
  const ParsedRules& rules() const { return *parsed_; }

 private:
  const TopologicalMap& map() const { return knowledge_->environment->map; }

  Problem problem_;
  Pose goal_;
  SceneKnowledgePtr knowledge_;
  StrategyRules rules_;
  SemanticEditsPtr edits_;
  std::optional<SemanticModel> semantics_;
  std::optional<ParsedRules> parsed_;
  std::map<int, Pose> kept_;  ///< per border
};

}  // namespace glissade
