#pragma once

#include "engine/base/stop_token.h"
#include "engine/environment/knowledge_source.h"
#include "engine/planning/coarse/passage_fit.h"
#include "engine/planning/coarse/strategy_rules.h"
#include "engine/planning/problem.h"

namespace glissade {

/// The environment model together with how the object fits its places: what the coarse planning
/// reads. Computed once for a scenario, then shared.
struct SceneKnowledge {
  EnvironmentModelPtr environment;
  std::vector<PassageFit> fits;  ///< per place
  KnowledgeSource source;
  std::vector<double> compatibility() const;
  std::uint64_t randomConfigurations() const;  ///< drawn by the probes in 3D
};
using SceneKnowledgePtr = std::shared_ptr<const SceneKnowledge>;

/// The environment model alone, with the bodies' mobility as edits have it. Errors are those of buildEnvironment.
Result<EnvironmentModelPtr> buildEnvironmentOf(const Problem& problem, const StopToken& stop = {});

/// Builds the environment model and fits the object through every passage. Edits of the
/// bodies' mobility are respected. `before` (may be null) is what was known before bodies were moved: what
/// stays of its model is not built again (updateEnvironment()). Errors are those of buildEnvironment, or Interrupted.
Result<SceneKnowledgePtr> buildSceneKnowledge(const Problem& problem, double requiredClearance,
                                              const StopToken& stop = {}, const SceneKnowledgePtr& before = nullptr);

/// The rules that a strategy plans by: its preset, or for "own" the problem's.
StrategyRules rulesOf(const Problem& problem, std::string_view strategy);

/// The semantic layer of a problem under these edits (null: none).
SemanticModel semanticsOf(const Problem& problem, const SceneKnowledge& knowledge, const SemanticEditsPtr& edits);

}  // namespace glissade
