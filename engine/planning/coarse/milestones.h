#pragma once

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

/// The end of the straight crossing of a passage that lies on a border's side; nothing where the
/// place is no passage, or has no straight crossing.
std::optional<Pose> fittedMilestone(const SceneKnowledge& knowledge, int place, int border);

}  // namespace glissade
