#pragma once

#include "engine/base/stop_token.h"
#include "engine/places/knowledge_source.h"
#include "engine/planning/coarse/passage_fit.h"
#include "engine/planning/coarse/strategy_rules.h"
#include "engine/planning/problem.h"

namespace glissade {

/// The environment model and how the object fits its places: the input of the coarse planning. Computed once for a
/// scenario, then shared.
struct SceneKnowledge {
  EnvironmentModelPtr environment;
  std::vector<PassageFit> fits;  ///< one entry per place
  KnowledgeSource source;
  std::vector<double> compatibility() const;
  std::uint64_t randomConfigurations() const;  ///< Random configurations drawn by the probes in 3D.
};
using SceneKnowledgePtr = std::shared_ptr<const SceneKnowledge>;

/// The environment model alone, with the mobility of bodies that the edits set. Errors are those of buildEnvironment.
Result<EnvironmentModelPtr> buildEnvironmentOf(const Problem& problem, const StopToken& stop = {});

/// Builds the environment model and fits the object through every passage. Edits of the bodies' mobility are respected.
/// `before` (may be null) is the knowledge before bodies were moved; the unchanged parts of its model are reused
/// (updateEnvironment()). Errors are those of buildEnvironment, or Interrupted.
Result<SceneKnowledgePtr> buildSceneKnowledge(const Problem& problem, double requiredClearance,
                                              const StopToken& stop = {}, const SceneKnowledgePtr& before = nullptr);

/// The rules of a strategy: its preset, or for "own" the problem's rules.
StrategyRules rulesOf(const Problem& problem, std::string_view strategy);

/// The semantic layer of a problem under these edits (null: none).
SemanticModel semanticsOf(const Problem& problem, const SceneKnowledge& knowledge, const SemanticEditsPtr& edits);

}  // namespace glissade
