#pragma once

#include <optional>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/planning/difficulty/least_penetration.h"
#include "engine/planning/roadmap.h"

namespace glissade {

/// A place where two trees do not meet: a person may show the way from one to the other there.
struct HelpPlace {
  Pose fromStart;         ///< of the start's tree
  Pose fromGoal;          ///< of the goal's tree, the nearest to it
  double distance = 0.0;  ///< between them in the metric, metres
  /// From one to the other, for an object that is thinner by `lacking`. Of the place on a whole way, the first and the
  /// last motion lead from the trees to that way and back, and may be blocked.
  std::vector<Pose> passage;
  Pose narrowest;  ///< the configuration of the passage where the object lacks most
  int body = -1;   ///< the obstacle there; -1: none
  /// By how much the object would have to be thinner to pass there, metres; 0: the passage is open. An upper bound, as
  /// erosion measures it. Nothing: no passage was found, and `passage` has its two ends only.
  std::optional<double> lacking;
};

/// The object lacks less than a thousandth of its radius (metres).
inline bool isOpen(const HelpPlace& place, double objectRadius) {
  return place.lacking && *place.lacking <= 1e-3 * objectRadius;
}

/// So many gaps are shown to a person.
inline constexpr std::size_t kHelpGaps = 3;
/// What is spent on the passage of one gap, and on a whole way.
inline constexpr PenetrationBudget kGapBudget{6'000, 10'000, 16};
inline constexpr PenetrationBudget kWholeWayBudget{20'000, 10'000, 16};

/// The places where a search has not got on. Among the nearest configurations of both trees, that is where a gap
/// begins that is not near another one's beginning, at most `gaps` of them; and, where a way of least penetration from
/// start to goal is known, the configurations of both trees that are nearest to its deepest one. Those come first where
/// help is worth most: where the object lacks least, then where the trees are nearest. Edges that were dropped are left
/// out of `edges`. Bounded by work, not by time; after a stop, what is known by then. On any thread.
std::vector<HelpPlace> helpPlaces(const Problem& problem, const std::vector<RoadmapNode>& nodes,
                                  const std::vector<RoadmapEdge>& edges, const ParameterValues& parameters,
                                  std::uint64_t seed, const std::optional<LeastPenetration>& wholeWay,
                                  std::size_t gaps = kHelpGaps, const PenetrationBudget& budget = kGapBudget,
                                  const WorkWatch& watch = {});

}  // namespace glissade
