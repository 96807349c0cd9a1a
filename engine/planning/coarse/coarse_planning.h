#pragma once

#include <map>

#include "engine/planning/coarse/milestones.h"
#include "engine/planning/coarse/topological_planner.h"

namespace glissade {

/// The coarse planning of one problem by one set of rules, with the known milestones. Runs and previews use it alike.
/// Not thread-safe.
class CoarsePlanning {
 public:
  /// `goal`: the configuration to plan for; for "out" a configuration outside. `edits` null: none.
  CoarsePlanning(const Problem& problem, const Pose& goal, SceneKnowledgePtr knowledge, StrategyRules rules,
                 SemanticEditsPtr edits);

  /// Replaces the edits. Forgets the kept milestones where the user's milestones have changed. Returns whether they
  /// have changed.
  bool setEdits(SemanticEditsPtr edits);
  /// The cheapest coarse path, with its basis. Milestones are not drawn yet. Errors are those of the rules.
  Result<CoarsePlan> plan(const LearntCosts& learnt);

  /// Keeps the milestone of a border for later coarse paths.
  void keep(int border, const Pose& milestone) { kept_[border] = milestone; }
  void forget(int border) { kept_.erase(border); }
  /// Forgets the milestones that are not free any more, because a place was forbidden.
  void forgetBlocked(CollisionQuery& query);
  bool keeps(int border) const { return kept_.count(border) > 0; }
  /// Keeps the milestones that a run has drawn, without the user's milestones.
  void keepMilestonesOf(const CoarsePlan& run, CollisionQuery& query);

  /// The end of a step, where it is known without drawing: the goal, the user's milestone, or the kept milestone.
  std::optional<Pose> decidedMilestone(const TopologicalStep& step, CollisionQuery& query) const;
  /// The decided milestone, or where the rules want it, the configuration that fits the passage best. `next`: the step
  /// after it, or null.
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
  std::map<int, Pose> kept_;  ///< one entry per border
};

}  // namespace glissade
