#pragma once

#include "engine/planning/difficulty/least_penetration.h"
#include "engine/planning/roadmap.h"

namespace glissade {

/// What a search that found no path ran into.
struct Difficulty {
  /// The nearest two configurations of the start's and the goal's trees.
  struct Frontier {
    Pose fromStart;
    Pose fromGoal;
    double distance = 0.0;  ///< in the metric, metres
    int body = -1;          ///< what the straight motion between them hits first; -1: nothing
    Pose blockedAt;         ///< where it does
  };
  /// Where the object came nearest to something on the ways grown to the frontier.
  struct Passage {
    double clearance = 0.0;  ///< metres
    int body = -1;
    Pose q;
  };

  std::optional<Frontier> frontier;  ///< nothing where a tree is missing
  std::optional<Passage> tightest;
  std::optional<LeastPenetration> leastPenetration;
};

/// Looks at the roadmap that was grown (edges that were dropped left out) and searches for the way of
/// least penetration. Bounded by the budget's work, not by time; where stopped, with what is known.
Difficulty difficultyOf(const Problem& problem, const std::vector<RoadmapNode>& nodes,
                        const std::vector<RoadmapEdge>& edges, const ParameterValues& parameters, std::uint64_t seed,
                        const PenetrationBudget& budget = {}, const WorkWatch& watch = {});

}  // namespace glissade
