#include "engine/planning/automatic/move_to_clearance.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "engine/base/number_text.h"
#include "engine/fits/contact_report.h"
#include "engine/planning/automatic/contact_faces.h"
#include "engine/planning/automatic/eroded_worlds.h"
#include "engine/planning/automatic/retraction.h"

namespace glissade {
namespace {

/// Depths of erosion, as shares of the object's radius. At depth 0 the object is too near to an obstacle but does not
/// touch it.
constexpr std::array<double, 9> kClearanceDepths{0.0, 1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2};
/// Clearances that the eroded object has to keep, in depths. The edges of the eroded object have moved by less than its
/// faces.
constexpr std::array<double, 3> kClearanceDemands{1.05, 1.5, 2.0};
/// Lengths of the slides, as shares of the object's radius: the shortest, the longest, and the ratio of each to the one
/// before.
constexpr double kShortestWayOut = 0.01;
constexpr double kLongestWayOut = 4.0;
constexpr double kWayOutFactor = 1.25;
constexpr std::size_t kWayOutFaces = 6;

class MoveToClearance {
 public:
  MoveToClearance(const CollisionWorldPtr& world, const Pose& q, double clearance, const StopToken& stop)
      : world_(world), q_(q), clearance_(clearance), stop_(stop), query_(world->makeQuery()), eroded_(world) {}

  bool isFree() { return query_->clearAbove(q_, clearance_); }

  std::optional<Pose> retract() {
    for (const double depth : kClearanceDepths) {
      const double by = depth * world_->objectRadius();
      const auto erodedQuery = eroded_.at(by)->makeQuery();
      for (const double demand : kClearanceDemands) {
        if (stop_.stopRequested()) return std::nullopt;
        const auto found = retracted(*erodedQuery, q_, demand * (by + clearance_), world_->objectRadius());
        if (found && query_->clearAbove(*found, clearance_)) return *found;
      }
    }
    return std::nullopt;
  }

  /// The shortest slide, made with the smallest erosion that permits one.
  std::optional<Pose> slideOut() {
    const std::vector<Pose> ends = slideEnds();
    for (const double depth : kClearanceDepths) {
      const double by = depth * world_->objectRadius();
      const auto erodedQuery = eroded_.at(by)->makeQuery();
      const double required = kErodedShare * (by + clearance_);
      if (!erodedQuery->clearAbove(q_, required)) continue;
      for (const Pose& end : ends) {
        const MotionCheck check = erodedQuery->checkMotion(q_, end, required, SeekViolation::Any, stop_);
        if (check.status == CertificateStatus::Certified) return end;
      }
    }
    return std::nullopt;
  }

  Diagnostic failure() {
    const auto colliding = query_->collidingBody(q_);
    const auto body = static_cast<std::size_t>(colliding ? *colliding : query_->nearestObstacle(q_).body);
    const Message reason = colliding ? overlapWith(body) : nearnessTo(body);
    return {ErrorKind::InCollision,
            "",
            "",
            {GLISSADE_TEXT("%1; no clear position was found within %2 mm"),
             {reason, shortText(1e3 * kLongestWayOut * world_->objectRadius())}},
            GLISSADE_TEXT("Switch fits on, put the object elsewhere, or check the parts and their unit.")};
  }

 private:
  /// Clearance that the eroded object keeps on its slide, as a share of the depth of erosion plus the clearance.
  static constexpr double kErodedShare = 0.1;

  std::vector<Vector3> directions() const {
    std::vector<Vector3> directions;
    directions.reserve(2 * (3 + kWayOutFaces));
    for (int axis = 0; axis < 3; ++axis) directions.push_back(Vector3::Unit(axis));
    for (const Vector3& normal_B : largestFaceNormals(world_->object(), kWayOutFaces)) {
      directions.push_back(q_.orientation * normal_B);
    }
    const std::size_t count = directions.size();
    for (std::size_t i = 0; i < count; ++i) directions.push_back(-directions[i]);
    return directions;
  }

  /// The first clear place in each direction, sorted by distance.
  std::vector<Pose> slideEnds() {
    std::vector<std::pair<double, Pose>> found;
    for (const Vector3& direction : directions()) {
      if (stop_.stopRequested()) break;
      for (double way = kShortestWayOut; way <= kLongestWayOut; way *= kWayOutFactor) {
        Pose end = q_;
        end.position += way * world_->objectRadius() * direction;
        if (!query_->clearAbove(end, clearance_)) continue;
        found.emplace_back(way, end);
        break;
      }
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Pose> ends;
    ends.reserve(found.size());
    for (const auto& [way, end] : found) ends.push_back(end);
    return ends;
  }

  Message nearnessTo(std::size_t body) const {
    return {GLISSADE_TEXT("the object is nearer to '%1' than the required clearance"),
            {world_->obstacles()[body].shown()}};
  }

  Message overlapWith(std::size_t body) const {
    const RigidBody& obstacle = world_->obstacles()[body];
    const auto object = std::make_shared<const TriangleMesh>(world_->object());
    const ContactReport report =
        findContacts({{obstacle.id, obstacle.mesh, obstacle.X_WB}, {"object", object, q_}}, {});
    if (report.contacts.empty()) return {GLISSADE_TEXT("the object penetrates '%1'"), {obstacle.shown()}};
    const double overlap = report.contacts.front().overlap;
    if (overlap <= 0.0) return {GLISSADE_TEXT("the object touches '%1'"), {obstacle.shown()}};
    return {GLISSADE_TEXT("the object overlaps '%1' by %2 mm"), {obstacle.shown(), shortText(1e3 * overlap)}};
  }

  const CollisionWorldPtr& world_;
  const Pose& q_;
  double clearance_;
  const StopToken& stop_;
  std::unique_ptr<CollisionQuery> query_;
  ErodedWorlds eroded_;
};

}  // namespace

Result<Pose> moveToClearance(const CollisionWorldPtr& world, const Pose& q, double required, const StopToken& stop) {
  MoveToClearance search(world, q, 2.0 * required, stop);
  if (search.isFree()) return q;
  if (const auto near = search.retract()) return *near;
  if (const auto out = search.slideOut()) return *out;
  if (stop.stopRequested())
    return Diagnostic{ErrorKind::Interrupted, "", "", GLISSADE_TEXT("the operation was stopped"), {}};
  return search.failure();
}

}  // namespace glissade
