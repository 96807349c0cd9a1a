#pragma once

#include "engine/base/parameters.h"
#include "engine/base/work_watch.h"
#include "engine/planning/path.h"
#include "engine/planning/problem.h"

namespace glissade {

/// Attempts where nobody says how many.
inline constexpr int kUsualShortcuts = 300;

/// Shortens a certified path: two points on it are drawn, and the way between them is replaced by a straight
/// motion, or made straight in one degree of freedom only, x, y, z or the orientation (R. Geraerts,
/// M. H. Overmars, "Creating high-quality paths for motion planning", 2007). What would be longer in
/// the metric, or is not certified against its demands (path_certificate.h), is not taken. At the end
/// configurations that can be left out are.
///
/// Ends after `attempts` tries, or when stopped, with what was taken so far. The same input and seed
/// give the same path. Shortcuts are the computer's; points on edges that slide stay contact
/// configurations, so that they keep their demand. The result is certified; where it is not (it was
/// stopped meanwhile) the path comes back as it was.
Path withShortcuts(const Path& path, const Problem& problem, const ParameterValues& parameters, std::uint64_t seed,
                   int attempts, const WorkWatch& watch = {});

}  // namespace glissade
