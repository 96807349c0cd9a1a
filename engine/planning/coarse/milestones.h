#pragma once

#include "engine/planning/coarse/coarse_plan.h"
#include "engine/planning/coarse/scene_knowledge.h"

namespace glissade {

/// Draws the milestone of a border: configurations random in its cells until one is free (paper 2,
/// sections 4.1 and 6.1).
class MilestoneSampler {
 public:
  MilestoneSampler(const TopologicalMap& map, int border, std::uint64_t seed);

  /// One random configuration; nothing where it collides or lies outside the bounds.
  std::optional<Pose> draw(CollisionQuery& query, const Box3& bounds);

 private:
  SamplingRegion region_;
  RandomStream stream_;
};

/// The milestone that a user has put into a border; nothing where there is none or it collides.
std::optional<Pose> editedMilestone(const TopologicalMap& map, int border, const SemanticEdits& edits,
                                    CollisionQuery& query);

/// The milestone of a step where its place or the next one (null: none) is a passage with a straight crossing:
/// that crossing's end on the border's side. Of two passages the tighter one has its way.
std::optional<Pose> fittedMilestone(const SceneKnowledge& knowledge, const TopologicalStep& step,
                                    const TopologicalStep* next);

}  // namespace glissade
