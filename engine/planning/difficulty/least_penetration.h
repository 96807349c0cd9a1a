#pragma once

#include <optional>
#include <vector>

#include "engine/base/parameters.h"
#include "engine/base/work_watch.h"
#include "engine/planning/problem.h"

namespace glissade {

/// A way from start to goal for an object that is allowed to penetrate, as little as could be found.
struct LeastPenetration {
  double depth = 0.0;  ///< metres: what has to give at the deepest point, as erosion measures it
  Pose q;              ///< the deepest configuration
  int body = -1;       ///< the obstacle there
  std::vector<Pose> way;
};

struct PenetrationBudget {
  std::uint64_t searchWork = 100'000;  ///< queries of the search for each erosion
  std::uint64_t repairWork = 30'000;   ///< queries of each repair
  int rounds = 16;                     ///< of growing back
};

/// Erodes the object by depths that double until a search finds a way, then lets it grow back in steps
/// that are halved where they fail, each time repairing the way found last. An upper bound of the least depth:
/// searches with a limit prove nothing. Nothing where no erosion up to 0.64 of the object's radius
/// helps (thin bodies keep a fifth of their thickness), or when stopped before the first way.
std::optional<LeastPenetration> leastPenetration(const Problem& problem, const ParameterValues& parameters,
                                                 std::uint64_t seed, const PenetrationBudget& budget = {},
                                                 const WorkWatch& watch = {});

}  // namespace glissade
