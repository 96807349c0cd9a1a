#include "engine/collision/grouped_query.h"

#include <algorithm>
#include <limits>

#include "engine/collision/motion_union.h"

namespace glissade {
namespace {

/// Distances of boxes are rounded by less than this share, and by less than this share of the coordinates.
constexpr double kRounding = 1e-9;
constexpr double kRoundings = 1e-15;

}  // namespace

GroupedQuery::GroupedQuery(const std::vector<ObstacleGroup>& groups, std::shared_ptr<const MotionBound> motionBound)
    : motionBound_(std::move(motionBound)) {
  for (const ObstacleGroup& group : groups) {
    const Box3& box = group.world->obstaclesBox();
    const double coordinates = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    parts_.push_back({group.world->makeQuery(), group.bodies, box, coordinates});
  }
}

/// No point of the object is nearer to the group, and none is inside; below zero where the object may reach it.
double GroupedQuery::leastDistance(const Part& part, const Pose& X_WB) const {
  return lessRounding(part, part.box.exteriorDistance(X_WB.position), X_WB.position);
}

/// On the straight motion. The reference point stays in the box of its ends.
bool GroupedQuery::mayReach(const Part& part, const Pose& from, const Pose& to, double required) const {
  Box3 way(from.position);
  way.extend(to.position);
  const Vector3 farthest = way.min().cwiseAbs().cwiseMax(way.max().cwiseAbs());
  return lessRounding(part, part.box.exteriorDistance(way), farthest) <= required;
}

/// A lower bound of the object's distance, from a distance of its reference point.
double GroupedQuery::lessRounding(const Part& part, double distance, const Vector3& position) const {
  const double coordinates = part.coordinates + position.cwiseAbs().maxCoeff();
  return distance * (1.0 - kRounding) - motionBound_->objectRadius() * (1.0 + kRounding) - kRoundings * coordinates;
}

bool GroupedQuery::collides(const Pose& X_WB) {
  ++counts_.collision;
  return std::any_of(parts_.begin(), parts_.end(),
                     [&](Part& part) { return leastDistance(part, X_WB) <= 0.0 && part.query->collides(X_WB); });
}

std::optional<int> GroupedQuery::collidingBody(const Pose& X_WB) {
  ++counts_.collision;
  std::optional<int> lowest;
  for (Part& part : parts_) {
    if (leastDistance(part, X_WB) > 0.0) continue;
    const auto body = part.query->collidingBody(X_WB);
    if (!body) continue;
    const int number = part.bodies[static_cast<std::size_t>(*body)];
    lowest = lowest ? std::min(*lowest, number) : number;
  }
  return lowest;
}

/// The group that was the nearest the last time is asked first, so that others need not be asked. The answer does not
/// depend on the order.
NearestObstacle GroupedQuery::nearestObstacle(const Pose& X_WB) {
  ++counts_.distance;
  NearestObstacle nearest;
  nearest.distance = std::numeric_limits<double>::infinity();
  const std::size_t first = lastNearest_;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const std::size_t index = i == 0 ? first : (i <= first ? i - 1 : i);
    Part& part = parts_[index];
    if (leastDistance(part, X_WB) > nearest.distance) continue;
    NearestObstacle found = part.query->nearestObstacle(X_WB);
    if (found.body < 0) continue;
    found.body = part.bodies[static_cast<std::size_t>(found.body)];
    const bool nearer = found.distance < nearest.distance;
    if (!nearer && !(found.distance == nearest.distance && found.body < nearest.body)) continue;
    nearest = found;
    lastNearest_ = index;
  }
  return nearest;
}

double GroupedQuery::distanceUpTo(const Pose& X_WB, double enough) {
  ++counts_.distance;
  double distance = enough;
  for (Part& part : parts_) {
    if (distance > 0.0 && leastDistance(part, X_WB) < distance) distance = part.query->distanceUpTo(X_WB, distance);
  }
  return distance;
}

bool GroupedQuery::clearAbove(const Pose& X_WB, double bound) {
  ++counts_.distance;
  return std::all_of(parts_.begin(), parts_.end(), [&](Part& part) {
    return leastDistance(part, X_WB) > bound || part.query->clearAbove(X_WB, bound);
  });
}

MotionCheck GroupedQuery::checkMotion(const Pose& from, const Pose& to, double required, SeekViolation seek,
                                      const StopToken& stop) {
  ++counts_.motion;
  MotionCheck united = certifiedMotion();
  for (Part& part : parts_) {
    if (!mayReach(part, from, to, required)) continue;
    unite(united, part.query->checkMotion(from, to, required, seek, stop));
    if (united.status == CertificateStatus::Violated && seek == SeekViolation::Any) break;
  }
  return united;
}

double GroupedQuery::screwClearance(const Pose& from, const ScrewAxis& screw, double advance, double enough,
                                    double off) {
  ++counts_.motion;
  for (Part& part : parts_) {
    if (enough > 0.0) enough = part.query->screwClearance(from, screw, advance, enough, off);
  }
  return enough;
}

/// A question counts once, however many groups it was passed on to.
QueryCounts GroupedQuery::counts() const {
  QueryCounts counts = counts_;
  for (const Part& part : parts_) counts.pairs += part.query->counts().pairs;
  return counts;
}

}  // namespace glissade
