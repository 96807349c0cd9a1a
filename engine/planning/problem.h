#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>

#include "engine/collision/collision_query.h"
#include "engine/geometry/se3_metric.h"
#include "engine/model/body_id.h"
#include "engine/places/semantic_model.h"
#include "engine/planning/sampling_region.h"

namespace glissade {

/// Goal "out": any configuration whose object is clear of the others' bounding box.
struct GoalOut {};
using Goal = std::variant<Pose, GoalOut>;

using SemanticEditsPtr = std::shared_ptr<const SemanticEdits>;
struct SceneKnowledge;  ///< see planning/coarse/scene_knowledge.h
struct StrategyRules;   ///< see planning/coarse/strategy_rules.h

/// Knowledge of the multi-layer planners beyond geometry. Immutable; shared by threads.
struct SceneDescription {
  BodyId objectId = "object";
  EnvironmentOptions environment;
  SemanticEditsPtr edits;                           ///< null: none
  std::shared_ptr<const SceneKnowledge> knowledge;  ///< null: a planner that needs it computes it
  std::shared_ptr<const StrategyRules> rules;       ///< rules of the strategy "own"; null: those of "gts"
};

/// Draws configurations for one planner, on its thread.
using ConfigurationDraw = std::function<Pose()>;
/// Makes the draw of a planner with this seed. Any thread.
using ConfigurationSource = std::function<ConfigurationDraw(std::uint64_t seed)>;

/// A planning problem. Immutable; shared by threads.
struct Problem {
  CollisionWorldPtr world;
  Pose start;
  Goal goal;
  Box3 bounds;               ///< bounds of the object's reference point, world frame
  SamplingRegionPtr region;  ///< region in which random configurations are drawn; null: the bounds
  SceneDescription scene;
  /// Draws random configurations instead of RandomShooter where the problem has no region; empty: none.
  ConfigurationSource source{};

  Se3Metric metric() const { return Se3Metric(world->objectRadius()); }
};

}  // namespace glissade
