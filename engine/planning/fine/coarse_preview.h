#pragma once

#include "engine/planning/coarse/coarse_plan.h"
#include "engine/planning/coarse/scene_knowledge.h"

namespace glissade {

/// What a preview of the coarse plan is asked for. A value: another thread may work with it.
struct PreviewQuestion {
  Problem problem;
  std::string strategy;
  SceneKnowledgePtr knowledge;  ///< null: not known yet
  SemanticEditsPtr edits;       ///< null: none
  CoarsePlanPtr run;            ///< the plan of the last run; null: none
};

/// The strategy plans coarsely first.
bool isMultiLayer(const std::string& strategy);

/// The plan was made on these places, so that its numbers of places and borders hold for them. True while the places
/// are not known.
bool isAboutPlaces(const CoarsePlan& plan, const SceneKnowledgePtr& knowledge);

/// The plan was also made with these edits and by the rules of this strategy: planning again would begin with it.
bool isUpToDate(const CoarsePlan& plan, const PreviewQuestion& question);

/// What the coarse planning would decide now. Steps whose milestone is not known have an estimate of their end. Known
/// are the user's milestones, and those of the last run where it was made by the same rules on the same places. Null
/// where the strategy makes no coarse plan, the places are not known, or there is no configuration outside; errors
/// are those of the rules. Any thread; deterministic.
Result<CoarsePlanPtr> previewPlan(const PreviewQuestion& question);

}  // namespace glissade
