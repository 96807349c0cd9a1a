#include "engine/sequence/two_line_removal.h"

#include <algorithm>

#include "engine/planning/path_certificate.h"
#include "engine/planning/screw_motion.h"
#include "engine/sequence/removal_directions.h"

namespace glissade {
namespace {

constexpr double kSameDirection = 1.0 - 1e-9;
/// Length of the first line, in lengths of the group along it, beyond which no end is tried.
constexpr double kFarthest = 2.0;
/// Share of the free length that is used: its end touches the blocking body.
constexpr double kBeforeTheEnd = 0.95;
/// Least length of the first line as a share of the group's length: below, the group has not left its place.
constexpr double kLeastWay = 0.02;

Box3 moved(const Box3& box, const Vector3& way) { return {box.min() + way, box.max() + way}; }

/// The search for one group among others, from a configuration of the group.
class TwoLines {
 public:
  TwoLines(const Pose& start, const MovingObject& object, const MotionWorld& motion, const StopToken& stop)
      : start_(start),
        object_(object),
        query_(motion.world->makeQuery()),
        box_(boundingBox(*object.mesh, start)),
        others_(motion.world->obstaclesBox()),
        stop_(stop) {}

  /// The configurations of a free motion; empty if there is none.
  std::vector<Pose> find(const std::vector<Vector3>& directions) {
    if (!query_->clearAbove(start_, object_.required)) return {};
    for (const Vector3& first : directions) {
      for (const double way : waysAlong(first)) {
        for (const Vector3& second : directions) {
          if (stop_.stopRequested()) return {};
          if (std::abs(second.dot(first)) > kSameDirection) continue;
          const Pose turning = along(start_, way * first);
          const double rest = wayOutOf(moved(box_, way * first), others_, second, leavingMargin(object_.radius));
          const Pose end = along(turning, rest * second);
          if (isFree(turning, end)) return {start_, turning, end};
        }
      }
    }
    return {};
  }

 private:
  static Pose along(Pose q, const Vector3& way) {
    q.position += way;
    return q;
  }

  /// Lengths of the first line: the group's length along it, and the free length.
  std::vector<double> waysAlong(const Vector3& direction) {
    const double length = box_.diagonal().dot(direction.cwiseAbs());
    const double farthest = kFarthest * length;
    const MotionCheck check =
        query_->checkMotion(start_, along(start_, farthest * direction), object_.required, SeekViolation::First, stop_);
    const bool isOpen = check.status == CertificateStatus::Certified;
    const double free = isOpen ? farthest : kBeforeTheEnd * check.certified * farthest;
    std::vector<double> ways;
    if (free > length) ways.push_back(length);
    if (free > kLeastWay * length) ways.push_back(free);
    return ways;
  }

  bool isFree(const Pose& from, const Pose& to) {
    const MotionCheck check = query_->checkMotion(from, to, object_.required, SeekViolation::Any, stop_);
    return check.status == CertificateStatus::Certified;
  }

  const Pose& start_;
  const MovingObject& object_;
  std::unique_ptr<CollisionQuery> query_;
  Box3 box_;
  Box3 others_;
  const StopToken& stop_;
};

}  // namespace

RemovalAnswer TwoLineRemoval::tryRemoval(const BodyGroup& group, const BodySet& present, const StopToken& stop) const {
  const std::vector<Pose> lines = linesFrom(worlds_.object(group).X_WB, group, present, stop);
  if (lines.empty()) return Refused{{}, stop.stopRequested()};
  const MotionWorld motion = worlds_.world(group, present);
  Path path{computedPoints(lines), {}};
  path.certificate = certifyPath(*motion.world->makeQuery(), path.points, worlds_.parameters(group), stop);
  if (path.certificate.status != CertificateStatus::Certified) return Refused{{}, stop.stopRequested()};
  nameByProduct(path.certificate, motion.bodies);
  return Removed{std::move(path), kTwoLines, fits_.fitsOf(group, present)};
}

std::vector<Pose> TwoLineRemoval::linesFrom(const Pose& start, const BodyGroup& group, const BodySet& present,
                                            const StopToken& stop) const {
  return TwoLines(start, worlds_.object(group), worlds_.world(group, present), stop).find(directionsOf(group));
}

/// The directions of the group's bodies, without duplicates.
std::vector<Vector3> TwoLineRemoval::directionsOf(const BodyGroup& group) const {
  std::vector<Vector3> directions;
  for (const std::size_t body : group) {
    for (const Vector3& direction : removalDirections(product_, fits_, body)) {
      const auto isSame = [&](const Vector3& other) { return other.dot(direction) > kSameDirection; };
      if (std::none_of(directions.begin(), directions.end(), isSame)) directions.push_back(direction);
    }
  }
  return directions;
}

}  // namespace glissade
