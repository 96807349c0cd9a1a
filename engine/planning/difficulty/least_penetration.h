#pragma once

#include <optional>
#include <vector>

#include "engine/base/parameters.h"
#include "engine/base/work_watch.h"
#include "engine/planning/problem.h"

namespace glissade {

/// A way from start to goal for an object that may penetrate, with the least penetration found.
struct LeastPenetration {
  double depth = 0.0;  ///< largest penetration, as erosion measures it, metres
  Pose q;              ///< configuration of the largest penetration
  int body = -1;       ///< the obstacle there
  std::vector<Pose> way;
};

struct PenetrationBudget {
  std::uint64_t searchWork = 100'000;  ///< limit of queries for the search at each erosion
  std::uint64_t repairWork = 30'000;   ///< limit of queries for each repair
  int rounds = 16;                     ///< rounds of growing back
};

/// Erodes the object by depths that double until a search finds a way. The object then grows back in steps, and each
/// step repairs the way found last. A step that fails is halved. The depth is an upper bound, because searches with a
/// limit prove nothing. Returns nothing where no erosion up to 0.64 of the object's radius helps (thin bodies keep a
/// fifth of their thickness), or after a stop before the first way.
std::optional<LeastPenetration> leastPenetration(const Problem& problem, const ParameterValues& parameters,
                                                 std::uint64_t seed, const PenetrationBudget& budget = {},
                                                 const WorkWatch& watch = {});

}  // namespace glissade
