#include "engine/sequence/turned_removal.h"

#include <set>

#include "engine/collision/thread_rule.h"
#include "engine/planning/path_certificate.h"
#include "engine/planning/screw_motion.h"
#include "engine/sequence/motion_world.h"
#include "engine/sequence/removal_directions.h"

namespace glissade {
namespace {

std::vector<PathPoint> computedPoints(const std::vector<Pose>& configurations) {
  std::vector<PathPoint> points;
  for (const Pose& q : configurations) points.push_back({q, Author::Computer, Author::Computer});
  return points;
}

}  // namespace

RemovalAnswer TurnedRemoval::tryRemoval(std::size_t body, const BodySet& present, const StopToken& stop) const {
  const MotionWorld motion = motionWorld(product_, fits_, prepared_, body, present);
  if (motion.world->threads().empty()) return Refused{};
  const RigidBody& own = product_.bodies[body];
  const ParameterValues parameters = motionParameters(own);
  const auto query = motion.world->makeQuery();
  ScrewSearch search = findScrewWays(*motion.world, *query, own.X_WB, parameters[ParameterId::RequiredClearance], stop);
  std::set<std::size_t> blocking;
  for (const int obstacle : search.blockedBy) blocking.insert(motion.bodies[static_cast<std::size_t>(obstacle)]);
  for (ScrewWay& way : search.ways) {
    Pose end = way.configurations.back();
    const Box3 box = boundingBox(*own.mesh, end);
    const double margin = leavingMargin(own);
    end.position += wayOutOf(box, motion.world->obstaclesBox(), way.direction_W, margin) * way.direction_W;
    way.configurations.push_back(end);
    Path path{computedPoints(way.configurations), {}};
    path.certificate = certifyPath(*query, path.points, parameters, stop);
    nameByProduct(path.certificate, motion.bodies);
    if (path.certificate.status == CertificateStatus::Certified) {
      return Removed{std::move(path), "turned", fits_.fitsOf(body, present)};
    }
    const int nearest = path.certificate.nearest.body;
    if (nearest >= 0) blocking.insert(static_cast<std::size_t>(nearest));
  }
  return Refused{{blocking.begin(), blocking.end()}, stop.stopRequested()};
}

}  // namespace glissade
