#pragma once

#include "engine/planning/coarse/coarse_plan.h"
#include "engine/planning/coarse/scene_knowledge.h"

namespace glissade {

/// Input of a preview of the coarse plan. A value, so that another thread may use it.
struct PreviewQuestion {
  Problem problem;
  std::string strategy;
  SceneKnowledgePtr knowledge;  ///< null: not known yet
  SemanticEditsPtr edits;       ///< null: none
  CoarsePlanPtr run;            ///< plan of the last run; null: none
};

/// True if the strategy plans coarsely first.
bool isMultiLayer(const std::string& strategy);

/// True if the plan was made on these places, so that its indices of places and borders are valid, or while the places
/// are not known.
bool isAboutPlaces(const CoarsePlan& plan, const SceneKnowledgePtr& knowledge);

/// True if the plan was also made with these edits and by the rules of this strategy, so that planning again would
/// begin with it.
bool isUpToDate(const CoarsePlan& plan, const PreviewQuestion& question);

/// The decisions that the coarse planning would make now. Known milestones are the user's, and those of the last run
/// where it was made by the same rules on the same places. Steps with an unknown milestone have an estimate of their
/// end. Null where the strategy makes no coarse plan, the places are not known, or there is no configuration outside.
/// Errors are those of the rules. Any thread; deterministic.
Result<CoarsePlanPtr> previewPlan(const PreviewQuestion& question);

}  // namespace glissade
