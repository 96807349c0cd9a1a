#pragma once

#include <optional>
#include <vector>

#include "engine/base/parameters.h"
#include "engine/planning/path.h"

namespace glissade {

/// What each edge of a path has to keep: the required clearance; half of the contact gap, if that is
/// less, where the edge begins or ends at a contact configuration, which keeps no more than the gap.
std::vector<EdgeDemand> demandsOf(const std::vector<PathPoint>& points, const ParameterValues& parameters);

/// Certifies a path edge by edge against its demands; stops at the first that is not certified.
MotionCertificate certifyPath(CollisionQuery& query, const std::vector<PathPoint>& points,
                              const ParameterValues& parameters, const StopToken& stop = {});

/// The first edge that the certificate refuses, without its distances: for paths of which most are refused.
std::optional<RefusedEdge> firstRefusedEdge(CollisionQuery& query, const std::vector<PathPoint>& points,
                                            const ParameterValues& parameters, const StopToken& stop = {});

}  // namespace glissade
