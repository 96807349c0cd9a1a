#pragma once

#include <memory>
#include <string>
#include <variant>

#include "engine/collision/collision_query.h"
#include "engine/environment/semantic_model.h"
#include "engine/geometry/se3_metric.h"
#include "engine/planning/sampling_region.h"

namespace glissade {

/// Goal "out": any configuration whose object is clear of the others' bounding box.
struct GoalOut {};
using Goal = std::variant<Pose, GoalOut>;

using SemanticEditsPtr = std::shared_ptr<const SemanticEdits>;
struct SceneKnowledge;  ///< planning/coarse/scene_knowledge.h
struct StrategyRules;   ///< planning/coarse/strategy_rules.h

/// What the multi-layer planners know beyond geometry. Immutable; shared by threads.
struct SceneDescription {
  std::string objectId = "object";
  EnvironmentOptions environment;
  SemanticEditsPtr edits;                           ///< null: none
  std::shared_ptr<const SceneKnowledge> knowledge;  ///< null: a planner that needs it computes it
  std::shared_ptr<const StrategyRules> rules;       ///< of strategy "own"; null: those of "gts"
};

/// One planning question. Immutable; shared by threads.
struct Problem {
  CollisionWorldPtr world;
  Pose start;
  Goal goal;
  Box3 bounds;               ///< of the object's reference point, world frame
  SamplingRegionPtr region;  ///< where random configurations are drawn; null: in the bounds
  SceneDescription scene;

  Se3Metric metric() const { return Se3Metric(world->objectRadius()); }
};

}  // namespace glissade
