#pragma once

#include <optional>
#include <vector>

#include "engine/base/parameters.h"
#include "engine/planning/path.h"

namespace glissade {

/// The clearance that each edge of a path has to keep: the required clearance, or half of the contact gap, if that is
/// less and the edge begins or ends at a contact configuration. A contact configuration keeps no more than the gap.
std::vector<EdgeDemand> demandsOf(const std::vector<PathPoint>& points, const ParameterValues& parameters);

/// Certifies a path edge by edge against its demands; stops at the first edge that is not certified.
MotionCertificate certifyPath(CollisionQuery& query, const std::vector<PathPoint>& points,
                              const ParameterValues& parameters, const StopToken& stop = {});

/// The first edge that the certificate refuses, without its distances. Faster than certifyPath() for paths most of
/// which are refused.
std::optional<RefusedEdge> firstRefusedEdge(CollisionQuery& query, const std::vector<PathPoint>& points,
                                            const ParameterValues& parameters, const StopToken& stop = {});

}  // namespace glissade
