#include "engine/planning/screw_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>

#include "engine/collision/thread_rule.h"

namespace glissade {
namespace {

/// Numbers of straight motions that replace a full turn. The smallest number with a free motion is taken. The reference
/// point moves on chords of its helix, so that an object whose reference point is far from the axis leaves its axis.
constexpr std::array<int, 5> kPieces{16, 32, 64, 128, 256};
/// Distance of two threads at which the object may move on, in pitches.
constexpr double kApart = 0.5;
/// Largest differences of the axes and pitches of threads that turn together: radians, metres, share.
constexpr double kSameDirection = 1e-4;
constexpr double kSameAxis = 1e-5;
constexpr double kSamePitch = 1e-6;

Message quoted(const CollisionWorld& world, int body) {
  if (body == kForbiddenPlace) return GLISSADE_TEXT("a forbidden place");
  return {GLISSADE_TEXT("'%1'"), {world.obstacles()[static_cast<std::size_t>(body)].shown()}};
}

/// The thread pairs in which the object is engaged.
std::vector<const ThreadPair*> engagedPairs(const CollisionWorld& world, const Pose& at) {
  std::vector<const ThreadPair*> engaged;
  for (const ThreadPair& pair : world.threads()) {
    if (pair.engaged(at)) engaged.push_back(&pair);
  }
  return engaged;
}

/// True if one screw motion follows both threads.
bool turnTogether(const ThreadRule& one, const ThreadRule& other) {
  const bool parallel = one.axis_W.cross(other.axis_W).norm() < kSameDirection;
  const bool coaxial = (other.point_W - one.point_W).cross(one.axis_W).norm() < kSameAxis;
  return parallel && coaxial && std::abs(one.pitch - other.pitch) < kSamePitch * std::abs(one.pitch);
}

std::vector<Pose> piecesOf(const ThreadRule& rule, const Pose& from, double advance, int perTurn) {
  const double turns = std::abs(advance / rule.pitch);
  const auto count = std::max(1, static_cast<int>(std::ceil(turns * perTurn)));
  std::vector<Pose> poses{from};
  for (int i = 1; i <= count; ++i) poses.push_back(screwed(rule, from, advance * i / count));
  return poses;
}

/// The first obstacle on a motion, and the share of the motion before it; nothing where it is free.
struct Blocking {
  int body;
  double share;
};

std::optional<Blocking> blockingOf(CollisionQuery& query, const std::vector<Pose>& poses, double required,
                                   const StopToken& stop) {
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const MotionCheck check = query.checkMotion(poses[i], poses[i + 1], required, SeekViolation::Any, stop);
    if (check.status == CertificateStatus::Certified) continue;
    const double at = check.status == CertificateStatus::Violated ? check.at : check.certified;
    const int body = query.nearestObstacle(interpolate(poses[i], poses[i + 1], at)).body;
    return Blocking{body, (static_cast<double>(i) + at) / static_cast<double>(poses.size() - 1)};
  }
  return std::nullopt;
}

/// A motion with the fewest pieces that is free; else the blocking of the finest one.
struct Tried {
  std::vector<Pose> poses;
  std::optional<Blocking> blocking;
};

Tried tryScrew(CollisionQuery& query, const ThreadRule& rule, const Pose& from, double advance, double required,
               const StopToken& stop) {
  Tried tried;
  for (const int perTurn : kPieces) {
    tried.poses = piecesOf(rule, from, advance, perTurn);
    const auto blocking = blockingOf(query, tried.poses, required, stop);
    if (!blocking || stop.stopRequested()) return {std::move(tried.poses), blocking};
    const bool sameAsBefore = tried.blocking && blocking->share < tried.blocking->share * (1.0 + 1e-2) + 1e-3;
    tried.blocking = blocking;
    if (sameAsBefore && perTurn >= kPieces[2]) break;  // finer pieces get no farther
  }
  return tried;
}

Message namesOf(const CollisionWorld& world, const std::set<int>& bodies) {
  std::vector<Message> names;
  for (const int body : bodies) names.push_back(quoted(world, body));
  return joined(names, ", ");
}

/// Advance along the axis of the first pair after which the object has left all pairs.
double advanceOutOf(const std::vector<const ThreadPair*>& pairs, const Pose& from, double sense) {
  const ThreadRule& first = pairs.front()->rule();
  double farthest = 0.0;
  for (const ThreadPair* pair : pairs) {
    const double own = pair->rule().axis_W.dot(first.axis_W) < 0.0 ? -sense : sense;
    farthest = std::max(farthest, std::abs(pair->advanceOut(from, own)));
  }
  return sense * (farthest + kApart * std::abs(first.pitch));
}

/// The reason why the object cannot be turned at all; empty where it can.
Message whyHeld(const CollisionWorld& world, const std::vector<const ThreadPair*>& pairs, std::set<int>& holding) {
  for (const ThreadPair* pair : pairs) {
    if (!pair->rule().mayTurn) holding.insert(pair->rule().obstacle);
  }
  if (!holding.empty()) {
    return {GLISSADE_TEXT("the object is in the thread of %1, which would turn with it"), {namesOf(world, holding)}};
  }
  const ThreadRule& first = pairs.front()->rule();
  for (const ThreadPair* pair : pairs) {
    if (turnTogether(first, pair->rule())) continue;
    holding = {first.obstacle, pair->rule().obstacle};
    return {GLISSADE_TEXT("the object is in the threads of %1, which cannot be unscrewed at the same time: their axes "
                          "or pitches differ"),
            {namesOf(world, holding)}};
  }
  return {};
}

}  // namespace

ScrewSearch findScrewWays(const CollisionWorld& world, CollisionQuery& query, const Pose& from, double required,
                          const StopToken& stop) {
  ScrewSearch search;
  const std::vector<const ThreadPair*> pairs = engagedPairs(world, from);
  if (pairs.empty()) return search;
  search.engaged = true;
  std::set<int> blocking;
  search.why = whyHeld(world, pairs, blocking);
  const ThreadRule& rule = pairs.front()->rule();
  for (const double sense : {1.0, -1.0}) {
    if (!search.why.empty() || stop.stopRequested()) break;
    const double advance = advanceOutOf(pairs, from, sense);
    Tried tried = tryScrew(query, rule, from, advance, required, stop);
    if (!tried.blocking && query.clearAbove(tried.poses.back(), required)) {
      search.ways.push_back({std::move(tried.poses), sense * rule.axis_W, sense * advance / rule.pitch});
    } else if (tried.blocking && tried.blocking->body >= 0) {
      blocking.insert(tried.blocking->body);
    } else if (!tried.blocking) {
      blocking.insert(rule.obstacle);  // the object does not fit there without the rule of the threads
    }
  }
  std::stable_sort(search.ways.begin(), search.ways.end(),
                   [](const ScrewWay& a, const ScrewWay& b) { return std::abs(a.turns) < std::abs(b.turns); });
  if (search.ways.empty() && search.why.empty()) {
    const Message reason = blocking.empty() ? Message(GLISSADE_TEXT("it has no room"))
                                            : Message(GLISSADE_TEXT("%1 is in the way"), {namesOf(world, blocking)});
    search.why = {GLISSADE_TEXT("the object cannot be unscrewed from %1, because %2"),
                  {quoted(world, rule.obstacle), reason}};
  }
  search.blockedBy = {blocking.begin(), blocking.end()};
  return search;
}

std::vector<Pose> screwBetween(const CollisionWorld& world, CollisionQuery& query, const Pose& from, const Pose& to,
                               double required, const StopToken& stop) {
  for (const ThreadPair* pair : engagedPairs(world, from)) {
    const ThreadRule& rule = pair->rule();
    const double advance = pair->advanceBetween(from, to);
    if (!rule.mayTurn || !pair->engaged(to) || !pair->isSame(to, screwed(rule, from, advance))) continue;
    Tried tried = tryScrew(query, rule, from, advance, required, stop);
    if (tried.blocking) continue;
    tried.poses.push_back(to);
    return std::move(tried.poses);
  }
  return {};
}

std::vector<PathPoint> computedPoints(const std::vector<Pose>& configurations) {
  std::vector<PathPoint> points;
  points.reserve(configurations.size());
  for (const Pose& q : configurations) points.push_back({q, Author::Computer, Author::Computer});
  return points;
}

}  // namespace glissade
