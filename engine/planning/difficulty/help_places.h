#pragma once

#include <optional>
#include <vector>

#include "engine/base/work_watch.h"
#include "engine/planning/difficulty/least_penetration.h"
#include "engine/planning/roadmap.h"

namespace glissade {

/// A place where two trees do not meet. A person may show a way between them there.
struct HelpPlace {
  Pose fromStart;         ///< configuration of the start's tree
  Pose fromGoal;          ///< nearest configuration of the goal's tree
  double distance = 0.0;  ///< distance between them in the metric, metres
  /// The passage from `fromStart` to `fromGoal`, for an object that is thinner by `lacking`. For a place on a whole
  /// way, the first and the last motion connect the trees with that way. They are free unless the way itself is blocked
  /// at its ends.
  std::vector<Pose> passage;
  Pose narrowest;  ///< the configuration of the passage with the largest penetration
  int body = -1;   ///< the obstacle there; -1: none
  /// The amount by which the object would have to be thinner to pass, metres; 0: the passage is open. An upper bound,
  /// measured by erosion. Nothing: no passage was found, and `passage` has its two ends only.
  std::optional<double> lacking;
};

/// True if the object lacks less than a thousandth of its radius (metres).
inline bool isOpen(const HelpPlace& place, double objectRadius) {
  return place.lacking && *place.lacking <= 1e-3 * objectRadius;
}

/// Number of gaps that are shown to a person.
inline constexpr std::size_t kHelpGaps = 3;
/// Budget for the passage of one gap, and for a whole way.
inline constexpr PenetrationBudget kGapBudget{6'000, 10'000, 16};
inline constexpr PenetrationBudget kWholeWayBudget{100'000, 50'000, 16};

/// The places where a search is stuck. A gap is a pair of nearest configurations of both trees; at most `gaps` gaps are
/// taken whose beginnings are not near each other. Where a way of least penetration from start to goal is known, the
/// part of it about its deepest configuration is added, from tree to tree. The places are sorted by the missing
/// clearance, then by the distance of the trees. `edges` has no dropped edges. Bounded by work, not by time. After a
/// stop, the places known so far are returned. Called on any thread.
std::vector<HelpPlace> helpPlaces(const Problem& problem, const std::vector<RoadmapNode>& nodes,
                                  const std::vector<RoadmapEdge>& edges, const ParameterValues& parameters,
                                  std::uint64_t seed, const std::optional<LeastPenetration>& wholeWay,
                                  std::size_t gaps = kHelpGaps, const PenetrationBudget& budget = kGapBudget,
                                  const WorkWatch& watch = {});

}  // namespace glissade
