#include "engine/sequence/two_line_removal.h"

#include <algorithm>
#include <optional>

#include "engine/planning/path_certificate.h"
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

/// The search for one group among others.
class TwoLines {
 public:
  TwoLines(const MovingObject& object, const MotionWorld& motion, const StopToken& stop)
      : object_(object),
        query_(motion.world->makeQuery()),
        box_(boundingBox(*object.mesh, object.X_WB)),
        others_(motion.world->obstaclesBox()),
        stop_(stop) {}

  bool startsClear() { return query_->clearAbove(object_.X_WB, object_.required); }

  /// The configurations of a free motion; nothing if there is none.
  std::optional<std::vector<Pose>> find(const std::vector<Vector3>& directions) {
    for (const Vector3& first : directions) {
      for (const double way : waysAlong(first)) {
        for (const Vector3& second : directions) {
          if (stop_.stopRequested()) return std::nullopt;
          if (std::abs(second.dot(first)) > kSameDirection) continue;
          const Pose turning = along(object_.X_WB, way * first);
          const double rest = wayOutOf(moved(box_, way * first), others_, second, leavingMargin(object_.radius));
          const Pose end = along(turning, rest * second);
          if (isFree(turning, end)) return std::vector<Pose>{object_.X_WB, turning, end};
        }
      }
    }
    return std::nullopt;
  }

  MotionCertificate certify(const std::vector<PathPoint>& path, const ParameterValues& parameters) {
    return certifyPath(*query_, path, parameters, stop_);
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
    const MotionCheck check = query_->checkMotion(object_.X_WB, along(object_.X_WB, farthest * direction),
                                                  object_.required, SeekViolation::First, stop_);
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

  const MovingObject& object_;
  std::unique_ptr<CollisionQuery> query_;
  Box3 box_;
  Box3 others_;
  const StopToken& stop_;
};

}  // namespace

RemovalAnswer TwoLineRemoval::tryRemoval(const BodyGroup& group, const BodySet& present, const StopToken& stop) const {
  const MotionWorld motion = worlds_.world(group, present);
  TwoLines lines(worlds_.object(group), motion, stop);
  if (!lines.startsClear()) return Refused{};
  const auto found = lines.find(directionsOf(group));
  if (!found) return Refused{{}, stop.stopRequested()};
  Path path;
  for (const Pose& q : *found) path.points.push_back({q, Author::Computer});
  path.certificate = lines.certify(path.points, worlds_.parameters(group));
  if (path.certificate.status != CertificateStatus::Certified) return Refused{{}, stop.stopRequested()};
  nameByProduct(path.certificate, motion.bodies);
  return Removed{std::move(path), kTwoLines, fits_.fitsOf(group, present)};
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
