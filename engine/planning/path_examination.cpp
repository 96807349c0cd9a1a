#include "engine/planning/path_examination.h"

#include <algorithm>
#include <utility>

#include "engine/planning/path_bounds.h"
#include "engine/planning/path_certificate.h"

namespace glissade {
namespace {

/// In radii of the object. Two configurations nearer than this are the same.
constexpr double kSame = 1e-6;

/// The edges from `first` on that do not keep their demand.
std::vector<BlockedEdge> blockedEdges(CollisionQuery& query, const std::vector<PathPoint>& points,
                                      const std::vector<EdgeDemand>& demands, std::size_t first,
                                      const WorkWatch& watch) {
  std::vector<BlockedEdge> blocked;
  for (std::size_t edge = first; edge < demands.size() && !watch.stop.stopRequested(); ++edge) {
    const Pose& to = points[std::min(edge + 1, points.size() - 1)].q;
    const MotionCertificate motion = certifyMotion(query, points[edge].q, to, demands[edge].clearance, watch.stop);
    if (motion.status != CertificateStatus::Certified) blocked.push_back({edge, motion.at, motion.nearest});
    watch.report(static_cast<double>(edge + 1) / static_cast<double>(demands.size()));
  }
  return blocked;
}

}  // namespace

PathEnds endsOf(const std::vector<PathPoint>& points, const Problem& problem) {
  const Se3Metric metric = problem.metric();
  const Pose& last = points.back().q;
  PathEnds ends;
  ends.start = metric.distance(points.front().q, problem.start) <= kSame * metric.radius();
  if (const Pose* goal = std::get_if<Pose>(&problem.goal)) {
    ends.goal = metric.distance(last, *goal) <= kSame * metric.radius();
  } else {
    const double clear = problem.world->obstaclesBox().exteriorDistance(last.position);
    ends.goal = clear >= problem.world->objectRadius() * (1.0 - kSame);
  }
  return ends;
}

PathExamination examinePath(std::vector<PathPoint> points, const Problem& problem, const ParameterValues& parameters,
                            const WorkWatch& watch) {
  const auto query = problem.world->makeQuery();
  PathExamination examination;
  examination.ends = endsOf(points, problem);
  examination.path = {std::move(points), {}};
  Path& path = examination.path;
  if (const auto outside = firstOutside(path.points, problem)) {
    const bool first = *outside == 0;
    examination.blocked = {{first ? 0 : *outside - 1, first ? 0.0 : 1.0, {}}};
    return examination;
  }
  path.certificate = certifyPath(*query, path.points, parameters, watch.stop);
  if (path.certificate.status != CertificateStatus::Certified) {
    examination.blocked =
        blockedEdges(*query, path.points, demandsOf(path.points, parameters), path.certificate.edge, watch);
  }
  examination.complete = !watch.stop.stopRequested();
  return examination;
}

std::vector<PathPoint> withUnitRotations(std::vector<PathPoint> points) {
  for (PathPoint& point : points) point.q.orientation.normalize();
  return points;
}

}  // namespace glissade
