#include "engine/sequence/motion_trial.h"

#include <algorithm>
#include <array>
#include <set>

#include "engine/fits/snap_ways.h"
#include "engine/planning/path_certificate.h"
#include "engine/planning/screw_motion.h"
#include "engine/sequence/swept_box.h"

namespace glissade {
namespace {

/// Work of the automatic planner (SearchedRemoval) for each effort: about 0.1, 0.25, 1 and 4 seconds.
constexpr std::array<std::uint64_t, MotionTrial::kMostSearches> kSearchWork{250'000, 1'000'000, 4'000'000, 16'000'000};

std::uint64_t searchWork(int effort) { return kSearchWork[static_cast<std::size_t>(effort - 1)]; }

/// Clearance of a tool from the bodies that it is brought past, metres.
constexpr double kToolClearance = 1e-5;

}  // namespace

MotionTrial::MotionTrial(const AssembledProduct& product, const ProductFits& fits, std::uint64_t seed, int searches,
                         MotionWorlds::Forbidden forbidden, const JointRules* joints, const ThreadDemands* threads,
                         const Vector3& up)
    : product_(product),
      fits_(fits),
      bodies_(product.bodies.size()),
      searches_(searches),
      worlds_(product, fits, std::move(forbidden)),
      straight_(product, fits, worlds_, threads, up),
      turned_(fits, worlds_),
      joints_(joints),
      threads_(threads),
      twoLines_(product, fits, worlds_),
      searched_(product, fits, worlds_, seed) {
  if (joints != nullptr) jointed_.emplace(product, fits, worlds_, *joints);
}

/// Refuses motions that the judge would refuse because they pull a thread, whatever has found them.
RemovalAnswer MotionTrial::tryRemoval(const BodyGroup& group, const BodySet& present, int effort,
                                      const StopToken& stop) {
  RemovalAnswer answer = answerOf(group, present, effort, stop);
  const auto* removed = std::get_if<Removed>(&answer);
  if (removed == nullptr) return answer;
  BodyGroup holding = pulledOff(group, removed->path.points, present);
  if (holding.empty()) return answer;
  return Refused{std::move(holding)};
}

/// The bodies that block the straight lines and those that the group fits refuse a search. A group that a thread or a
/// hook holds is not searched: a hook bends on one line only.
RemovalAnswer MotionTrial::answerOf(const BodyGroup& group, const BodySet& present, int effort, const StopToken& stop) {
  if (joints_ != nullptr) {
    const std::vector<std::size_t> opened = joints_->opened(group, present);
    if (!opened.empty()) return tryTurning(group, present, effort, opened, stop);
  }
  if (effort == 0) return tryDirectly(group, present, stop);
  RemovalAnswer answer = Refused{};
  if (!turned_.isHeld(group, present) && !fits_.isHooked(group, present)) {
    answer = search(group, present, effort, stop);
  }
  auto* refused = std::get_if<Refused>(&answer);
  if (refused == nullptr || refused->stopped) return answer;
  const RemovalAnswer direct = tryDirectly(group, present, stop);
  const auto* lines = std::get_if<Refused>(&direct);
  if (lines == nullptr || lines->stopped) return direct;
  std::set<std::size_t> blocking(lines->blockedBy.begin(), lines->blockedBy.end());
  for (const Fit& fit : fits_.fitsOf(group, present)) blocking.insert(fit.obstacle);
  refused->blockedBy.assign(blocking.begin(), blocking.end());
  return answer;
}

/// Removal along two lines is tried before the first search.
RemovalAnswer MotionTrial::search(const BodyGroup& group, const BodySet& present, int effort, const StopToken& stop) {
  if (effort == 1) {
    RemovalAnswer lines = twoLines_.tryRemoval(group, present, stop);
    if (std::holds_alternative<Removed>(lines)) return lines;
  }
  return searched_.tryRemoval(group, present, searchWork(effort), stop);
}

/// A hooked group does not turn. Marked threads have rules in the motion worlds. A mesh without stated faces gets no
/// allowance for its facets at other angles than the assembled one, unless a person marks the thread: such a group may
/// leave along a straight line.
RemovalAnswer MotionTrial::tryTurning(const BodyGroup& group, const BodySet& present, int effort,
                                      const std::vector<std::size_t>& opened, const StopToken& stop) {
  if (fits_.isHooked(group, present)) return Refused{joints_->holders(opened, group, present)};
  const bool marked = fits_.isInThread(group, present);
  RemovalAnswer answer =
      marked ? turned_.tryRemoval(group, present, stop) : jointed_->tryRemoval(group, present, opened, stop);
  const auto* held = std::get_if<Refused>(&answer);
  if (held != nullptr && !held->stopped && !marked && hasFacetsOnly(group, opened)) {
    answer = straight_.tryRemoval(group, present, stop);
  }
  const auto* refused = std::get_if<Refused>(&answer);
  if (effort == 0 || marked || refused == nullptr || refused->stopped) return answer;
  RemovalAnswer searched = searchAfterTurn(group, present, effort, opened, stop);
  return std::holds_alternative<Removed>(searched) ? searched : answer;
}

/// The turn out of the threads, then two lines before the first search.
RemovalAnswer MotionTrial::searchAfterTurn(const BodyGroup& group, const BodySet& present, int effort,
                                           const std::vector<std::size_t>& opened, const StopToken& stop) {
  const std::vector<Pose> turned = jointed_->turnOut(group, present, opened);
  if (turned.empty()) return Refused{{}, stop.stopRequested()};
  const auto leavingBy = [&](const std::vector<PathPoint>& rest) {
    std::vector<PathPoint> points = computedPoints(turned);
    points.insert(points.end(), rest.begin() + 1, rest.end());
    return certified(group, points, kTurned, present, stop);
  };
  if (effort == 1) {
    const std::vector<Pose> lines = twoLines_.linesFrom(turned.back(), group, present, stop);
    auto removed = lines.empty() ? std::nullopt : leavingBy(computedPoints(lines));
    if (removed) return std::move(*removed);
  }
  RemovalAnswer answer = searched_.tryRemoval(group, present, turned.back(), searchWork(effort), stop);
  const auto* found = std::get_if<Removed>(&answer);
  if (found == nullptr) return answer;
  auto removed = leavingBy(found->path.points);
  if (!removed) return Refused{{}, stop.stopRequested()};
  return std::move(*removed);
}

/// True if a body that turns in these joints, or a body that it turns in, has no stated faces.
bool MotionTrial::hasFacetsOnly(const BodyGroup& group, const std::vector<std::size_t>& opened) const {
  const auto isFaceless = [&](std::size_t body) { return product_.bodies[body].mesh->faces.empty(); };
  if (std::any_of(group.begin(), group.end(), isFaceless)) return true;
  return std::any_of(opened.begin(), opened.end(), [&](std::size_t index) {
    const Joint& joint = joints_->joints()[index];
    return isFaceless(joint.body) || std::any_of(joint.others.begin(), joint.others.end(), isFaceless);
  });
}

/// The bodies that block the lines or the turn refuse both.
RemovalAnswer MotionTrial::tryDirectly(const BodyGroup& group, const BodySet& present, const StopToken& stop) {
  RemovalAnswer straight = straight_.tryRemoval(group, present, stop);
  auto* lines = std::get_if<Refused>(&straight);
  if (lines == nullptr || lines->stopped) return straight;
  RemovalAnswer turned = turned_.tryRemoval(group, present, stop);
  const auto* turns = std::get_if<Refused>(&turned);
  if (turns == nullptr || turns->stopped) return turned;
  std::set<std::size_t> blocking(lines->blockedBy.begin(), lines->blockedBy.end());
  blocking.insert(turns->blockedBy.begin(), turns->blockedBy.end());
  lines->blockedBy.assign(blocking.begin(), blocking.end());
  return straight;
}

std::vector<BodyGroup> MotionTrial::groupsAlongLines(const GroupQuestion& question, ThreadTeam& team,
                                                     const StopToken& stop) {
  if (joints_ == nullptr) return straight_.groups(question, {}, team, stop);
  return straight_.groups(question, joints_->links(question.present), team, stop);
}

std::vector<std::size_t> MotionTrial::inTheWay(const BodyGroup& group, const std::vector<PathPoint>& path,
                                               const std::vector<std::size_t>& left, const StopToken& stop) {
  const Box3 swept = worlds_.sweptBy(group, path);
  std::vector<std::size_t> blocking;
  for (const std::size_t other : left) {
    if (!swept.intersects(worlds_.boxOf(other))) continue;
    BodySet alone(bodies_, false);
    alone[other] = true;
    const MotionWorld motion = worlds_.world(group, alone);
    if (firstRefusedEdge(*motion.world->makeQuery(), path, worlds_.parameters(group), stop)) blocking.push_back(other);
    if (stop.stopRequested()) return {};
  }
  return blocking;
}

/// Bodies whose threads the motion pulls the group off.
BodyGroup MotionTrial::pulledOff(const BodyGroup& group, const std::vector<PathPoint>& path, const BodySet& present) {
  if (threads_ == nullptr) return {};
  const std::vector<Pose> configurations = configurationsOf(path);
  std::set<std::size_t> holding;
  for (const Fit& fit : fits_.fitsOf(group, present)) {
    const Pose X_GB = inverse(worlds_.object(group).X_WB) * product_.bodies[fit.object].X_WB;
    std::vector<Pose> ofBody;
    for (const Pose& q : configurations) ofBody.push_back(q * X_GB);
    if (!threads_->pulled(fit.object, fit.obstacle, ofBody).empty()) holding.insert(fit.obstacle);
  }
  return {holding.begin(), holding.end()};
}

/// Applies the judge's rule for hooks to each body of the group.
bool MotionTrial::keepsToBends(const BodyGroup& group, const std::vector<PathPoint>& path, const BodySet& present) {
  if (!fits_.isHooked(group, present)) return true;
  const std::vector<Pose> configurations = configurationsOf(path);
  for (const std::size_t body : group) {
    const RigidBody& own = product_.bodies[body];
    const Pose X_GB = inverse(worlds_.object(group).X_WB) * own.X_WB;
    std::vector<Pose> ofBody;
    for (const Pose& q : configurations) ofBody.push_back(q * X_GB);
    for (const std::size_t other : bodiesIn(without(present, group))) {
      const Vector3* way = fits_.bentWay(body, other);
      if (way != nullptr && !keepsToWay(*way, own, ofBody, product_.bodies[other])) return false;
    }
  }
  return true;
}

std::optional<Removed> MotionTrial::certified(const BodyGroup& group, const std::vector<PathPoint>& path,
                                              const std::string& method, const BodySet& present,
                                              const StopToken& stop) {
  if (!keepsToBends(group, path, present) || !pulledOff(group, path, present).empty()) return std::nullopt;
  const MotionWorld motion = worlds_.world(group, present);
  Removed removed{{path, certifyPath(*motion.world->makeQuery(), path, worlds_.parameters(group), stop)},
                  method,
                  fits_.fitsOf(group, present)};
  if (removed.path.certificate.status != CertificateStatus::Certified) return std::nullopt;
  nameByProduct(removed.path.certificate, motion.bodies);
  return removed;
}

std::vector<std::size_t> MotionTrial::inTheWayOfTool(const MeshPtr& tool, const std::pair<Pose, Pose>& motion,
                                                     const std::vector<std::size_t>& others, const StopToken& stop) {
  const Box3 swept = sweptBox(*tool, {motion.first, motion.second});
  std::vector<std::size_t> blocking;
  for (const std::size_t other : others) {
    if (!swept.intersects(worlds_.boxOf(other))) continue;
    const MotionCheck check = worlds_.beside(tool, other)
                                  ->makeQuery()
                                  ->checkMotion(motion.first, motion.second, kToolClearance, SeekViolation::Any, stop);
    if (check.status != CertificateStatus::Certified) blocking.push_back(other);
  }
  return blocking;
}

void MotionTrial::learn(const BodyGroup& group, const std::vector<PathPoint>& path) { straight_.learn(group, path); }

}  // namespace glissade
