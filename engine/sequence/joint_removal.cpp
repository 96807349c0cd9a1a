#include "engine/sequence/joint_removal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "engine/planning/path_certificate.h"
#include "engine/planning/screw_motion.h"
#include "engine/sequence/removal_directions.h"

namespace glissade {
namespace {

/// Shorter turns are not proved as a turn.
constexpr double kLeastTurns = 1.25;
/// Limits of the configurations of one turn.
constexpr int kFewest = 4;
constexpr int kMost = 64;
/// Configurations of a turn that are tested before it is proved. The number is prime, so that they are at many angles.
constexpr int kSamples = 13;
/// Largest deviation of the chords of a turn from the helix, as a share of the required clearance.
constexpr double kOffShare = 0.2;
/// Joints open together if their axes and pitches differ by less: sine of the angle, metres, share.
constexpr double kSameDirection = 1e-4;
constexpr double kSameAxis = 1e-5;
constexpr double kSamePitch = 1e-6;

}  // namespace

std::vector<Pose> turnedAlong(const ScrewAxis& screw, const Pose& from, double advance, double off) {
  const double arm = (from.position - screw.point_W).cross(screw.axis_W).norm();
  int perTurn = kFewest;
  while (perTurn < kMost && arm * (1.0 - std::cos(std::numbers::pi / perTurn)) > off) perTurn *= 2;
  const double turns = std::abs(advance / screw.pitch);
  const auto count = std::max(1, static_cast<int>(std::ceil(turns * perTurn - 1e-9)));
  std::vector<Pose> poses{from};
  for (int i = 1; i <= count; ++i) poses.push_back(screwed(screw, from, advance * i / count));
  return poses;
}

std::optional<JointRemoval::Turn> JointRemoval::commonTurn(const BodyGroup& group,
                                                           const std::vector<std::size_t>& opened) const {
  std::optional<Turn> common;
  for (const std::size_t index : opened) {
    const Joint& joint = rules_.joints()[index];
    const JointThread& thread = *joint.thread;
    if (!(std::abs(thread.pitch) > 0.0) || !(joint.direction.norm() > 0.0)) return std::nullopt;
    const bool isFastener = std::binary_search(group.begin(), group.end(), joint.body);
    const Vector3 axis = (isFastener ? 1.0 : -1.0) * joint.direction.normalized();
    const double advance = std::abs(thread.pitch) * std::max(kLeastTurns, thread.turns());
    if (!common) {
      common = Turn{{joint.point, axis, thread.pitch}, advance};
      continue;
    }
    const ScrewAxis& screw = common->screw;
    const bool alike = screw.axis_W.cross(axis).norm() < kSameDirection && screw.axis_W.dot(axis) > 0.0 &&
                       (joint.point - screw.point_W).cross(screw.axis_W).norm() < kSameAxis &&
                       std::abs(screw.pitch - thread.pitch) < kSamePitch * std::abs(screw.pitch);
    if (!alike) return std::nullopt;
    common->advance = std::max(common->advance, advance);
  }
  return common;
}

std::optional<Refused> JointRemoval::known(const BodyGroup& group, const BodySet& present) const {
  const std::lock_guard lock(mutex_);
  const auto found = refused_.find(group);
  if (found == refused_.end()) return std::nullopt;
  const std::vector<std::size_t>& blocking = found->second.blockedBy;
  const bool holds = std::all_of(blocking.begin(), blocking.end(), [&](std::size_t body) { return present[body]; });
  return holds ? std::optional(found->second) : std::nullopt;
}

RemovalAnswer JointRemoval::tryRemoval(const BodyGroup& group, const BodySet& present,
                                       const std::vector<std::size_t>& opened, const StopToken& stop) {
  if (const auto refusal = known(group, present)) return *refusal;
  const auto turn = commonTurn(group, opened);
  if (!turn) return Refused{rules_.holders(opened, group, present)};
  RemovalAnswer answer = tryTurn(group, present, *turn, stop);
  auto* refused = std::get_if<Refused>(&answer);
  if (refused == nullptr || refused->stopped) return answer;
  if (const auto other = otherEnd(*turn, group, present, opened)) {
    RemovalAnswer byOther = tryTurn(group, present, *other, stop);
    const auto* held = std::get_if<Refused>(&byOther);
    if (held == nullptr || held->stopped) return byOther;
    std::set<std::size_t> blocking(refused->blockedBy.begin(), refused->blockedBy.end());
    blocking.insert(held->blockedBy.begin(), held->blockedBy.end());
    refused->blockedBy.assign(blocking.begin(), blocking.end());
  }
  if (refused->blockedBy.empty()) return answer;
  const std::lock_guard lock(mutex_);
  refused_[group] = *refused;
  return answer;
}

/// The turn in the opposite direction, until the group is past the bodies that hold it, as a nut at the other end of a
/// rod. Nothing where these do not let it: the head of a screw, the bottom of a hole.
std::optional<JointRemoval::Turn> JointRemoval::otherEnd(const Turn& turn, const BodyGroup& group,
                                                         const BodySet& present,
                                                         const std::vector<std::size_t>& opened) {
  const BodyGroup holders = rules_.holders(opened, group, present);
  const auto hasHead = [&](std::size_t index) { return rules_.joints()[index].kind == JointKind::Screw; };
  if (holders.empty() || std::any_of(opened.begin(), opened.end(), hasHead)) return std::nullopt;
  const Vector3 back = -turn.screw.axis_W;
  const MovingObject& object = worlds_.object(group);
  double behind = std::numeric_limits<double>::infinity();  // least height of the group along the way back
  for (const Vector3& vertex : object.mesh->vertices) behind = std::min(behind, back.dot(object.X_WB * vertex));
  double end = behind;
  BodySet alone(present.size(), false);
  for (const std::size_t holder : holders) {
    alone[holder] = true;
    const RigidBody& body = product_.bodies[holder];
    for (const Vector3& vertex : body.mesh->vertices) end = std::max(end, back.dot(body.X_WB * vertex));
  }
  const double advance = end - behind + kLeastTurns * std::abs(turn.screw.pitch);
  const Turn other{{turn.screw.point_W, back, turn.screw.pitch}, advance};
  const auto query = worlds_.world(group, alone).world->makeQuery();
  return turnIsFree(*query, other, object) ? std::optional(other) : std::nullopt;
}

RemovalAnswer JointRemoval::tryTurn(const BodyGroup& group, const BodySet& present, const Turn& turn,
                                    const StopToken& stop) {
  const MovingObject& object = worlds_.object(group);
  const std::vector<Pose> turned = turnedAlong(turn.screw, object.X_WB, turn.advance, kOffShare * object.required);
  if (turnIsFree(*worlds_.world(group, present).world->makeQuery(), turn, object)) {
    RemovalAnswer answer = leaveAfter(turned, turn.screw.axis_W, group, present, stop);
    const auto* refused = std::get_if<Refused>(&answer);
    if (refused == nullptr || refused->stopped) return answer;
  }
  const Pose end = outOf(othersBox(group), turned.back(), turn.screw.axis_W, object);
  return Refused{blockersOf(group, present, turn, {turned.back(), end}, stop), stop.stopRequested()};
}

/// The motion from the end of a turn: straight on, or along another line. The refusal names no body.
RemovalAnswer JointRemoval::leaveAfter(const std::vector<Pose>& turned, const Vector3& axis, const BodyGroup& group,
                                       const BodySet& present, const StopToken& stop) {
  const MovingObject& object = worlds_.object(group);
  const MotionWorld motion = worlds_.world(group, present);
  const auto query = motion.world->makeQuery();
  const Box3 others = othersBox(group);
  std::vector<Vector3> directions{axis};
  for (const Vector3& direction : removalDirections(product_, fits_, group.front())) directions.push_back(direction);
  for (const Vector3& direction : directions) {
    const Pose end = outOf(others, turned.back(), direction, object);
    const auto free = query->checkMotion(turned.back(), end, object.required, SeekViolation::Any, stop);
    if (stop.stopRequested()) return Refused{{}, true};
    if (free.status != CertificateStatus::Certified) continue;
    std::vector<Pose> all = turned;
    all.push_back(end);
    Path path{computedPoints(all), {}};
    path.certificate = certifyPath(*query, path.points, worlds_.parameters(group), stop);
    if (path.certificate.status != CertificateStatus::Certified) continue;
    nameByProduct(path.certificate, motion.bodies);
    return Removed{std::move(path), kTurned, fits_.fitsOf(group, present)};
  }
  return Refused{{}, stop.stopRequested()};
}

std::vector<Pose> JointRemoval::turnOut(const BodyGroup& group, const BodySet& present,
                                        const std::vector<std::size_t>& opened) {
  const auto turn = commonTurn(group, opened);
  const MovingObject& object = worlds_.object(group);
  if (!turn || !turnIsFree(*worlds_.world(group, present).world->makeQuery(), *turn, object)) return {};
  return turnedAlong(turn->screw, object.X_WB, turn->advance, kOffShare * object.required);
}

/// The box of all other bodies of the product: the end of a step has to be outside of it, because the step may come
/// earlier in another order.
Box3 JointRemoval::othersBox(const BodyGroup& group) const {
  return boxOf(product_, without(BodySet(product_.bodies.size(), true), group));
}

/// Proves the turn for all angles. The chords of the path deviate from the turn by a share of the clearance. Sample
/// angles are tested first, because a collision there makes the proof superfluous.
bool JointRemoval::turnIsFree(CollisionQuery& query, const Turn& turn, const MovingObject& object) {
  const double off = kOffShare * object.required;
  for (int i = 0; i <= kSamples; ++i) {
    if (!query.clearAbove(screwed(turn.screw, object.X_WB, turn.advance * i / kSamples), object.required)) return false;
  }
  const double apart = query.distanceUpTo(object.X_WB, object.radius);
  if (apart < object.required + off) return false;
  return query.screwClearance(object.X_WB, turn.screw, turn.advance, apart, off) >= object.required + off;
}

Pose JointRemoval::outOf(const Box3& others, Pose from, const Vector3& direction, const MovingObject& object) {
  const Box3 box = boundingBox(*object.mesh, from);
  from.position += wayOutOf(box, others, direction, leavingMargin(object.radius)) * direction;
  return from;
}

/// Tests each of the other bodies alone; returns those that the motion hits.
std::vector<std::size_t> JointRemoval::blockersOf(const BodyGroup& group, const BodySet& present, const Turn& turn,
                                                  const std::pair<Pose, Pose>& on, const StopToken& stop) {
  const MovingObject& object = worlds_.object(group);
  const Box3 swept = worlds_.sweptBy(group, computedPoints({object.X_WB, on.first, on.second}));
  std::vector<std::size_t> blocking;
  for (const std::size_t other : bodiesIn(without(present, group))) {
    if (stop.stopRequested()) return {};
    if (!swept.intersects(worlds_.boxOf(other))) continue;
    BodySet alone(present.size(), false);
    alone[other] = true;
    const auto query = worlds_.world(group, alone).world->makeQuery();
    const bool isFree = turnIsFree(*query, turn, object) &&
                        query->checkMotion(on.first, on.second, object.required, SeekViolation::Any, stop).status ==
                            CertificateStatus::Certified;
    if (!isFree) blocking.push_back(other);
  }
  if (!blocking.empty()) return blocking;
  // No single body blocks the motion, but it was not proved against all of them together.
  std::set<std::size_t> near;
  for (const Fit& fit : fits_.fitsOf(group, present)) near.insert(fit.obstacle);
  return {near.begin(), near.end()};
}

}  // namespace glissade
