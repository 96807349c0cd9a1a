#pragma once

#include "engine/base/message.h"
#include "engine/planning/coarse/scene_knowledge.h"
#include "engine/planning/coarse/topological_planner.h"

namespace glissade {

/// The semantic planner's choice for one topological step (paper 2, section 4.2).
struct FineChoice {
  bool geometrical = false;
  std::string local;
  Message why;
};

/// The choice for a step with known ends: the first rule that holds for its place decides. A step whose ends are those
/// of a straight crossing is crossed straight, if the rules want passages crossed in the configuration that fits best.
FineChoice chooseFor(const TopologicalStep& step, const SceneKnowledge& knowledge, const SemanticModel& semantics,
                     const ParsedRules& rules);

/// The choice of the first rule that holds for the place.
FineChoice chooseFinePlanners(const TopologicalMap& map, const SemanticModel& semantics, const ParsedRules& rules,
                              int place, double distance);

/// The choice where a straight motion was blocked: the planners of the first rule, which is for the
/// hardest places.
FineChoice fallbackFor(const ParsedRules& rules, const FineChoice& blocked);

/// The area of a step: its place with the borders at both ends (-1: none). With `geometrical` it is reduced to the
/// surroundings of a path of cells; an area without such a path is kept whole.
SamplingRegionPtr areaOf(const SceneKnowledge& knowledge, int place, int fromBorder, int toBorder, bool geometrical,
                         const Pose& from, const Pose& to, double objectRadius, const StopToken& stop = {});

}  // namespace glissade
