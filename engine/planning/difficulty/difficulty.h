#pragma once

#include "engine/planning/difficulty/least_penetration.h"
#include "engine/planning/roadmap.h"

namespace glissade {

/// The places at which a search failed to find a path, and the bodies that block it.
struct Difficulty {
  /// The nearest two configurations of the start's and the goal's trees.
  struct Frontier {
    Pose fromStart;
    Pose fromGoal;
    double distance = 0.0;  ///< distance in the metric, metres
    int body = -1;          ///< first obstacle that the straight motion between them hits; -1: none
    Pose blockedAt;         ///< configuration at that obstacle
  };
  /// The place of least clearance on the ways from the roots to the frontier.
  struct Passage {
    double clearance = 0.0;  ///< metres
    int body = -1;
    Pose q;
  };

  std::optional<Frontier> frontier;  ///< nothing where a tree is missing
  std::optional<Passage> tightest;
  std::optional<LeastPenetration> leastPenetration;
};

/// Examines the roadmap without dropped edges, and searches for the way of least penetration. Bounded by the budget's
/// work, not by time. After a stop, the result has the findings so far.
Difficulty difficultyOf(const Problem& problem, const std::vector<RoadmapNode>& nodes,
                        const std::vector<RoadmapEdge>& edges, const ParameterValues& parameters, std::uint64_t seed,
                        const PenetrationBudget& budget = {}, const WorkWatch& watch = {});

}  // namespace glissade
