#pragma once

#include <optional>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/planning/difficulty/least_penetration.h"
#include "engine/planning/roadmap.h"

namespace glissade {

/// A place where two trees do not meet: a person may show the way from one to the other there.
struct HelpPlace {
  Pose fromStart;              ///< of the start's tree
  Pose fromGoal;               ///< of the goal's tree, the nearest to it
  double distance = 0.0;       ///< between them in the metric, metres
  std::vector<Pose> passage;   ///< from one to the other, for an object that is thinner by `lacking`
  Pose narrowest;              ///< the configuration of the passage where the object lacks most
  int body = -1;               ///< the obstacle there; -1: none
  /// By how much the object would have to be thinner to pass there, metres; 0: the passage is open. An upper bound, as
  /// erosion measures it. Nothing: no passage was found, and `passage` has its two ends only.
  std::optional<double> lacking;
};

/// So many places are shown to a person.
inline constexpr std::size_t kHelpPlaces = 3;
/// What is spent on the passage of one place.
inline constexpr PenetrationBudget kHelpBudget{6'000, 10'000, 16};

/// The places where a search has not got on. Among the nearest configurations of both trees, that is where a gap
/// begins that is not near another one's beginning. At most `most` of them, those where help is worth most first: where
/// the object lacks least, then where the trees are nearest. Edges that were dropped are left out of `edges`. Bounded
/// by work, not by time; after a stop, what is known by then. On any thread.
std::vector<HelpPlace> helpPlaces(const Problem& problem, const std::vector<RoadmapNode>& nodes,
                                  const std::vector<RoadmapEdge>& edges, const ParameterValues& parameters,
                                  std::uint64_t seed, std::size_t most = kHelpPlaces, const PenetrationBudget& budget = kHelpBudget,
                                  const WorkWatch& watch = {});

}  // namespace glissade
