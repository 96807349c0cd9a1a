#include "engine/collision/grouped_query.h"

#include <algorithm>
#include <limits>

namespace glissade {

GroupedQuery::GroupedQuery(const std::vector<ObstacleGroup>& groups, std::shared_ptr<const MotionBound> motionBound)
    : motionBound_(std::move(motionBound)) {
  for (const ObstacleGroup& group : groups) parts_.push_back({group.world->makeQuery(), group.bodies});
}

bool GroupedQuery::collides(const Pose& X_WB) {
  ++counts_.collision;
  return std::any_of(parts_.begin(), parts_.end(), [&](Part& part) { return part.query->collides(X_WB); });
}

std::optional<int> GroupedQuery::collidingBody(const Pose& X_WB) {
  ++counts_.collision;
  std::optional<int> lowest;
  for (Part& part : parts_) {
    const auto body = part.query->collidingBody(X_WB);
    if (!body) continue;
    const int number = part.bodies[static_cast<std::size_t>(*body)];
    lowest = lowest ? std::min(*lowest, number) : number;
  }
  return lowest;
}

NearestObstacle GroupedQuery::nearestObstacle(const Pose& X_WB) {
  ++counts_.distance;
  NearestObstacle nearest;
  nearest.distance = std::numeric_limits<double>::infinity();
  for (Part& part : parts_) {
    NearestObstacle found = part.query->nearestObstacle(X_WB);
    if (found.body < 0) continue;
    found.body = part.bodies[static_cast<std::size_t>(found.body)];
    const bool nearer = found.distance < nearest.distance;
    if (nearer || (found.distance == nearest.distance && found.body < nearest.body)) nearest = found;
  }
  return nearest;
}

double GroupedQuery::distanceUpTo(const Pose& X_WB, double enough) {
  ++counts_.distance;
  double distance = enough;
  for (Part& part : parts_) {
    if (distance > 0.0) distance = part.query->distanceUpTo(X_WB, distance);
  }
  return distance;
}

bool GroupedQuery::clearAbove(const Pose& X_WB, double bound) {
  ++counts_.distance;
  return std::all_of(parts_.begin(), parts_.end(), [&](Part& part) { return part.query->clearAbove(X_WB, bound); });
}

MotionCheck GroupedQuery::checkMotion(const Pose& from, const Pose& to, double required, SeekViolation seek,
                                      const StopToken& stop) {
  ++counts_.motion;
  MotionCheck united;
  united.status = CertificateStatus::Certified;
  united.certified = 1.0;
  for (Part& part : parts_) {
    const MotionCheck check = part.query->checkMotion(from, to, required, seek, stop);
    united.configurations += check.configurations;
    united.certified = std::min(united.certified, check.certified);
    if (check.status == CertificateStatus::Violated) {
      united.at = united.status == CertificateStatus::Violated ? std::min(united.at, check.at) : check.at;
      united.status = CertificateStatus::Violated;
      if (seek == SeekViolation::Any) return united;
    } else if (check.status == CertificateStatus::Undecided && united.status == CertificateStatus::Certified) {
      united.status = CertificateStatus::Undecided;
    }
  }
  return united;
}

}  // namespace glissade
