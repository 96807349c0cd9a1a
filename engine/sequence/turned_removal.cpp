#include "engine/sequence/turned_removal.h"

#include <algorithm>
#include <set>

#include "engine/planning/path_certificate.h"
#include "engine/planning/screw_motion.h"
#include "engine/sequence/joint_removal.h"
#include "engine/sequence/removal_directions.h"

namespace glissade {

std::optional<TurnedRemoval::Known> TurnedRemoval::known(const BodyGroup& group, const BodySet& present) const {
  const std::lock_guard lock(mutex_);
  const auto found = refused_.find(group);
  if (found == refused_.end()) return std::nullopt;
  const std::vector<std::size_t>& blocking = found->second.blockedBy;
  const bool holds = std::all_of(blocking.begin(), blocking.end(), [&](std::size_t body) { return present[body]; });
  return holds ? std::optional(found->second) : std::nullopt;
}

/// A refusal that names no body is not stored, so that the group is tried again.
void TurnedRemoval::remember(const BodyGroup& group, const Known& refusal) {
  if (refusal.blockedBy.empty()) return;
  const std::lock_guard lock(mutex_);
  refused_[group] = refusal;
}

bool TurnedRemoval::isHeld(const BodyGroup& group, const BodySet& present) const {
  const auto refusal = known(group, present);
  return refusal && refusal->held && fits_.isInThread(group, present);
}

RemovalAnswer TurnedRemoval::tryRemoval(const BodyGroup& group, const BodySet& present, const StopToken& stop) {
  if (!fits_.isInThread(group, present)) return Refused{};
  if (const auto refusal = known(group, present)) return Refused{refusal->blockedBy};
  const MotionWorld motion = worlds_.world(group, present);
  const MovingObject& object = worlds_.object(group);
  const auto query = motion.world->makeQuery();
  ScrewSearch search = findScrewWays(*motion.world, *query, object.X_WB, object.required, stop);
  std::set<std::size_t> blocking;
  for (const int obstacle : search.blockedBy) blocking.insert(motion.bodies[static_cast<std::size_t>(obstacle)]);
  for (ScrewWay& way : search.ways) {
    Pose end = way.configurations.back();
    const Box3 box = boundingBox(*object.mesh, end);
    const double margin = leavingMargin(object.radius);
    end.position += wayOutOf(box, motion.world->obstaclesBox(), way.direction_W, margin) * way.direction_W;
    way.configurations.push_back(end);
    Path path{computedPoints(way.configurations), {}};
    path.certificate = certifyPath(*query, path.points, worlds_.parameters(group), stop);
    nameByProduct(path.certificate, motion.bodies);
    if (path.certificate.status == CertificateStatus::Certified) {
      return Removed{std::move(path), kTurned, fits_.fitsOf(group, present)};
    }
    const int nearest = path.certificate.nearest.body;
    if (nearest >= 0) blocking.insert(static_cast<std::size_t>(nearest));
  }
  Refused refused{{blocking.begin(), blocking.end()}, stop.stopRequested()};
  if (!refused.stopped) remember(group, {refused.blockedBy, search.engaged && search.ways.empty()});
  return refused;
}

}  // namespace glissade
