#pragma once

#include "engine/base/parameters.h"
#include "engine/base/work_watch.h"
#include "engine/planning/path.h"
#include "engine/planning/problem.h"

namespace glissade {

/// Default number of attempts.
inline constexpr int kUsualShortcuts = 300;

/// Shortens a certified path: two points on it are drawn, and the way between them is replaced by a straight motion, or
/// made straight in one degree of freedom only, x, y, z or the orientation (R. Geraerts, M. H. Overmars, "Creating
/// high-quality paths for motion planning", 2007). A replacement is refused if it is longer in the metric or not
/// certified against its demands (path_certificate.h). At the end, configurations that are not needed are removed.
///
/// Ends after `attempts` tries, or at a stop, with the changes made so far. The same input and seed give the same path.
/// Shortcuts are the computer's; points on edges in contact stay contact configurations, so that they keep their
/// demand. The result is certified. Where a stop prevents that, the path is returned unchanged.
Path withShortcuts(const Path& path, const Problem& problem, const ParameterValues& parameters, std::uint64_t seed,
                   int attempts, const WorkWatch& watch = {});

/// A certified path with withShortcuts() in those of its stretches whose motions are all the computer's. Motions that a
/// hand has led and contact samples about the held object stay as they are. The attempts are shared among the stretches
/// by their number of edges. Where a stop prevents the certificate, the path is returned unchanged.
Path withShortcutsOfComputer(const Path& path, const Problem& problem, const ParameterValues& parameters,
                             std::uint64_t seed, int attempts, const StopToken& stop = {});

}  // namespace glissade
