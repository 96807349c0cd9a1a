#include "engine/planning/path_certificate.h"

#include <algorithm>

namespace glissade {
namespace {

/// Share of the gap that the edge between two contact configurations has to keep. The gap shrinks there where the
/// object turns or the surface bulges.
constexpr double kGapShare = 0.5;

}  // namespace

std::vector<EdgeDemand> demandsOf(const std::vector<PathPoint>& points, const ParameterValues& parameters) {
  const double required = parameters[ParameterId::RequiredClearance];
  const double gap = std::min(required, kGapShare * parameters[ParameterId::ContactGap]);
  std::vector<EdgeDemand> demands;
  const std::size_t edges = points.size() > 1 ? points.size() - 1 : points.size();
  for (std::size_t i = 0; i < edges; ++i) {
    const std::size_t end = std::min(i + 1, points.size() - 1);
    const bool sliding = points[i].author == Author::Contact || points[end].author == Author::Contact;
    demands.push_back({sliding ? gap : required, sliding});
  }
  return demands;
}

MotionCertificate certifyPath(CollisionQuery& query, const std::vector<PathPoint>& points,
                              const ParameterValues& parameters, const StopToken& stop) {
  return certifyPath(query, configurationsOf(points), demandsOf(points, parameters), stop);
}

std::optional<RefusedEdge> firstRefusedEdge(CollisionQuery& query, const std::vector<PathPoint>& points,
                                            const ParameterValues& parameters, const StopToken& stop) {
  return firstRefusedEdge(query, configurationsOf(points), demandsOf(points, parameters), stop);
}

}  // namespace glissade
