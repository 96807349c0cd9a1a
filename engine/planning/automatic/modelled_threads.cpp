#include "engine/planning/automatic/modelled_threads.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace glissade {
namespace {

/// Share of the object's radius. An object that is farther from all obstacles is in no thread.
constexpr double kApartRadius = 0.1;
/// Largest deviation of a goal in the same thread from the screw motion, in pitches.
constexpr double kAxisShare = 0.2;
/// Distance of two threads after the object has left, in pitches.
constexpr double kBeyond = 1.0;
/// Share of the measured clearance that the chords of the helix may take.
constexpr double kChordShare = 0.2;
constexpr int kFewestPieces = 12;
constexpr int kMostPieces = 1024;
constexpr double kMostPoses = 100'000;
/// Number of configurations that are tested before a whole motion is proved.
constexpr int kLooks = 48;

/// Advance after which the two threads no longer overlap.
double advanceBeyond(const ModelledThread& thread, double sense) {
  const double beyond = kBeyond * std::abs(thread.screw.pitch);
  return sense > 0.0 ? std::max(0.0, thread.obstacleHigh - thread.objectLow) + beyond
                     : std::min(0.0, thread.obstacleLow - thread.objectHigh) - beyond;
}

/// The obstacle nearest to the first sampled configuration of the motion that is not clear. This test is cheap and
/// finds most obstacles.
std::optional<int> blockedOn(CollisionQuery& query, const ScrewAxis& screw, const Pose& from, double advance,
                             double required) {
  for (int i = 1; i <= kLooks; ++i) {
    // The samples are denser near the beginning, where most motions are blocked.
    const Pose q = screwed(screw, from, advance * std::pow(static_cast<double>(i) / kLooks, 2));
    if (!query.clearAbove(q, required)) return query.nearestObstacle(q).body;
  }
  return std::nullopt;
}

/// The motion in pieces whose chords take little of its clearance; empty where the motion is not proved free.
std::vector<Pose> provedScrew(CollisionQuery& query, const ScrewAxis& screw, const Pose& from, double advance,
                              double required) {
  const double enough = query.nearestObstacle(from).distance;
  const double shown = query.screwClearance(from, screw, advance, enough, 2.0 * kChordShare * enough);
  if (shown * (1.0 - 2.0 * kChordShare) <= required) return {};
  const double arm = (from.position - screw.point_W).cross(screw.axis_W).norm();
  const double angle = std::sqrt(8.0 * kChordShare * shown / std::max(arm, 1e-300));
  const double perTurn = std::max<double>(kFewestPieces, std::ceil(2.0 * std::numbers::pi / angle));
  const double pieces = std::ceil(std::abs(advance / screw.pitch) * perTurn);
  if (perTurn > kMostPieces || pieces > kMostPoses) return {};
  std::vector<Pose> poses{from};
  for (double i = 1.0; i <= pieces; i += 1.0) poses.push_back(screwed(screw, from, advance * i / pieces));
  return poses;
}

}  // namespace

std::vector<ModelledThread> findModelledThreads(const CollisionWorld& world, const Pose& at) {
  std::vector<ModelledThread> threads;
  const double apart = world.makeQuery()->distanceUpTo(at, kApartRadius * world.objectRadius());
  if (apart >= kApartRadius * world.objectRadius() || !world.threads().empty()) return threads;
  for (const RigidBody& body : world.obstacles()) {
    const auto found = findModelledThreads(world.object(), at, body, apart);
    threads.insert(threads.end(), found.begin(), found.end());
  }
  return threads;
}

ScrewSearch ModelledThreadWays::out(CollisionQuery& query, const Pose& from, double required,
                                    const StopToken& stop) const {
  ScrewSearch search;
  const std::vector<ModelledThread> threads = findModelledThreads(*world_, from);
  search.engaged = !threads.empty();
  if (threads.empty()) return search;
  std::vector<int> blocking;
  for (const ModelledThread& thread : threads) {
    for (const double sense : {1.0, -1.0}) {
      if (stop.stopRequested()) return search;
      const double advance = advanceBeyond(thread, sense);
      if (const auto body = blockedOn(query, thread.screw, from, advance, required)) {
        blocking.push_back(*body);
        continue;
      }
      std::vector<Pose> poses = provedScrew(query, thread.screw, from, advance, required);
      if (poses.empty()) continue;
      search.ways.push_back({std::move(poses), sense * thread.screw.axis_W, sense * advance / thread.screw.pitch});
    }
    if (!search.ways.empty()) break;
  }
  std::stable_sort(search.ways.begin(), search.ways.end(),
                   [](const ScrewWay& a, const ScrewWay& b) { return std::abs(a.turns) < std::abs(b.turns); });
  std::sort(blocking.begin(), blocking.end());
  blocking.erase(std::unique(blocking.begin(), blocking.end()), blocking.end());
  search.blockedBy = std::move(blocking);
  if (search.ways.empty()) search.why = GLISSADE_TEXT("no screw motion out of the modelled thread is free");
  return search;
}

std::vector<Pose> ModelledThreadWays::between(CollisionQuery& query, const Pose& from, const Pose& to, double required,
                                              const StopToken& stop) const {
  for (const ModelledThread& thread : findModelledThreads(*world_, from)) {
    if (stop.stopRequested()) break;
    const ScrewAxis& screw = thread.screw;
    const double advance = (to.position - from.position).dot(screw.axis_W);
    const Pose reached = screwed(screw, from, advance);
    const double off = (reached.position - to.position).norm() +
                       world_->objectRadius() * angleBetween(reached.orientation, to.orientation);
    if (off > kAxisShare * std::abs(screw.pitch) || blockedOn(query, screw, from, advance, required)) continue;
    std::vector<Pose> poses = provedScrew(query, screw, from, advance, required);
    if (poses.empty()) continue;
    poses.push_back(to);
    return poses;
  }
  return {};
}

}  // namespace glissade
