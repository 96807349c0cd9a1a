#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/planning/path.h"
#include "engine/planning/problem.h"

namespace glissade {

/// The first configuration of a path whose reference point is outside the problem's bounds; nothing where all are
/// inside. The bounds are extended to the start and the goal, and a rounding error of 1e-6 radii is accepted. Edges are
/// straight, so that an edge with both ends inside stays inside.
std::optional<std::size_t> firstOutside(const std::vector<PathPoint>& points, const Problem& problem);

}  // namespace glissade
