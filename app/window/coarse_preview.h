#pragma once

#include "engine/planning/coarse/coarse_plan.h"
#include "widgets/bridge/session_bridge.h"
#include "widgets/document/semantic_document.h"

namespace glissade {

/// The strategy plans coarsely first.
bool isMultiLayer(const std::string& strategy);

/// A plan that was made on these places, so that its numbers of places and borders hold for them. One that is
/// shown before they are known, too.
bool isAboutPlaces(const CoarsePlan& plan, const SemanticDocument& document);

/// It was also made with these edits and by the rules of this strategy: planning again would begin like it.
bool isUpToDate(const CoarsePlan& plan, const SemanticDocument& document, const Problem& problem,
                const std::string& strategy);

/// What the coarse planning would decide now. Known are the user's milestones, and those of `run` (may be null)
/// where it was made by the same rules on the same places. Null where the strategy makes no coarse plan or the
/// places are not known; errors are those of the rules.
Result<CoarsePlanPtr> previewPlan(const SemanticDocument& document, const Problem& problem, const std::string& strategy,
                                  const CoarsePlanPtr& run);

}  // namespace glissade
