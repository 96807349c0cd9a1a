#include "engine/planning/interactive/hand_follower.h"

#include <algorithm>
#include <cmath>

#include "engine/base/tolerances.h"
#include "engine/planning/automatic/tube_sampler.h"

namespace glissade {
namespace {

/// Steps about a gap of the way, for each movement of the hand.
constexpr int kGapSamples = 8;
/// Configurations near the one that is shown, where that cannot be retracted.
constexpr int kAttempts = 8;
/// Share of the computer's steps that search a gap of the way, while there is one.
constexpr double kGapShare = 0.5;
/// Deviation of configurations about a gap, in the distance that they bridge.
constexpr double kDeviation = 0.25;
/// Sliding in contact: length of a motion in radii of the object, how many at most, and what share of its length each
/// has to bring.
constexpr double kPiece = 0.15;
constexpr int kPieces = 6;
constexpr double kProgress = 0.2;
/// Share of the computer's configurations that are between the hand and the goal, and their deviation in the distance
/// of both.
constexpr double kAhead = 0.8;
constexpr double kAheadDeviation = 0.3;

}  // namespace

HandFollower::HandFollower(const Problem& problem, std::uint64_t seed, std::shared_ptr<ErodedWorlds> worlds)
    : AddTreePlanner(problem),
      stream_(seed, "hand"),
      shooter_(problem, seed),
      contactSampler_(seed),
      worlds_(std::move(worlds)),
      configuration_(problem, worlds_, seed, kAttempts),
      way_(metric_),
      gaps_(problem, seed, worlds_),
      tuner_(problem.world->objectRadius()),
      shown_(problem.start),
      free_(problem.start) {}

bool HandFollower::solve(PlannerHost& host) {
  while (!path_) {
    const std::size_t edgesBefore = roadmap_.edges().size();
    computersTurn_ = false;
    step(host);
    deliverPath(host);
    observe(edgesBefore, host);
    updateCounts();
    counts_.queries += configuration_.counts();
    counts_.queries += gaps_.queries();
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

bool HandFollower::hasWork(const OperatorSample& sample, bool extras) const {
  return movedFar(sample.q_device) || (extras && (contactSamplesLeft_ > 0 || (gapSamplesLeft_ > 0 && way_.isBehind())));
}

bool HandFollower::movedFar(const Pose& q) const {
  return metric_.distance(q, shown_) >= FollowedWay::kSame * metric_.radius();
}

InteractionSettings HandFollower::settings(const ParameterValues& parameters) const {
  return settingsInForce(parameters, tuner_.settings());
}

void HandFollower::step(PlannerHost& host) {
  ++counts_.iterations;
  const auto sample = host.operatorSample();
  const bool moved = sample && movedFar(sample->q_device);
  const bool gap = gapSamplesLeft_ > 0 && way_.isBehind();
  if (turn_ == Turn::Computer) {
    sampleForComputer(host);
  } else if (moved && !(gap && gapNext_)) {
    follow(sample->q_device, host);
    gapNext_ = true;
  } else if (contactSamplesLeft_ > 0) {
    sampleContact(host);
    gapNext_ = false;
  } else if (gap) {
    searchGap(host);
    gapNext_ = false;
  } else {
    passStep(Author::Operator);
  }
}

void HandFollower::follow(const Pose& q, PlannerHost& host) {
  ++counts_.operatorConfigurations;
  ++report_.shown;
  shown_ = q;
  contactSamplesLeft_ = 0;
  if (!problem_.bounds.contains(q.position)) {
    passStep(Author::Operator);
    return;
  }
  const double gap = host.parameters()[ParameterId::ContactGap];
  const auto clear = configuration_.clearConfiguration(q, gap);
  free_ = clear ? clear->q : q;
  if (!clear || clear->moved > 0.0) ++report_.collided;
  if (clear && clear->moved > 0.0) ++report_.movedToContact;
  const bool another = way_.add(free_, clear ? clear->nearest : NearestObstacle(),
                                clear ? clear->moved : ShownConfiguration::kMostMoved * metric_.radius());
  addTree(free_, Author::Operator, host);
  slide(free_, host);
  if (startTreeIsAt(free_)) {
    way_.reachedAll();
    return;
  }
  followWay();
  gapSamplesLeft_ = kGapSamples;
  const InteractionSettings inForce = settings(host.parameters());
  if (!another || !clear || clear->nearest.distance >= inForce.contactDistance) return;
  OperatorSample touching;
  touching.q_device = free_;
  touching.nearest = clear->nearest;
  contactClearance_ = clear->nearest.distance;
  contactSampler_.enter(touching, gap, host.parameters()[ParameterId::ContactRadius]);
  contactSamplesLeft_ = inForce.contactSamples;
}

void HandFollower::followWay() { way_.follow(roadmap_, roadmap_.componentOf(startRoot_)); }

bool HandFollower::startTreeIsAt(const Pose& q) const {
  return roadmap_.nearest(roadmap_.componentOf(startRoot_), q).distance <= FollowedWay::kSame * metric_.radius();
}

void HandFollower::sampleContact(PlannerHost& host) {
  --contactSamplesLeft_;
  ++counts_.contactConfigurations;
  const Pose q = contactSampler_.sample();
  if (problem_.bounds.contains(q.position)) {
    addTree(q, Author::Contact, host);
  } else {
    passStep(Author::Contact);
  }
}

/// Local planning from the start's tree to a point of the way that it has not reached.
void HandFollower::searchGap(PlannerHost& host) {
  const GapBridges::State state = gaps_.step(roadmap_, roadmap_.componentOf(startRoot_), way_, host);
  if (state == GapBridges::State::NothingToSearch) {
    sampleGap(host);
    return;
  }
  passStep(Author::Operator);
  if (state == GapBridges::State::Searching) return;
  const auto& [from, poses] = gaps_.bridge();
  Node at = from;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    at = roadmap_.addChild(at, {poses[i], Author::Operator, roadmap_.nodes()[from].side});
  }
  followWay();
}

/// Samples if no configuration beyond the gap is free: near a point of the way, or between that point and the tree.
void HandFollower::sampleGap(PlannerHost& host) {
  const Pose& target = way_.anyMissing(stream_);
  const auto near = roadmap_.nearest(roadmap_.componentOf(startRoot_), target);
  const Pose between = interpolate(roadmap_.nodes()[near.index].q, target, std::sqrt(stream_.uniform()));
  const double least = FollowedWay::kSame * metric_.radius();
  const double deviation = std::max(least, kDeviation * near.distance) * stream_.uniform();
  const Pose q = perturbed(between, deviation, metric_.radius(), problem_.bounds, stream_);
  addTree(q, Author::Operator, host);
  slide(q, host);
  followWay();
}

void HandFollower::sampleForComputer(PlannerHost& host) {
  if (way_.isBehind() && stream_.uniform() < kGapShare) {
    searchGap(host);
    return;
  }
  ++counts_.randomConfigurations;
  Pose q = shooter_.shoot();
  if (!goalRoots_.empty() && stream_.uniform() < kAhead) {
    const Pose& goal = roadmap_.nodes()[goalRoots_.front()].q;
    const double deviation = kAheadDeviation * metric_.distance(free_, goal);
    q = perturbed(interpolate(free_, goal, stream_.uniform()), deviation, metric_.radius(), problem_.bounds, stream_);
  }
  addTree(q, Author::Computer, host);
  slide(q, host);
  followWay();
}

/// Continues in contact from configurations at which a component was blocked on its way to q: a short motion towards q
/// is retracted from the obstacle, as long as this approaches q.
void HandFollower::slide(const Pose& q, PlannerHost& host) {
  const double piece = kPiece * metric_.radius();
  const double gap = host.parameters()[ParameterId::ContactGap];
  for (const ComponentId component : roadmap_.components()) {
    auto near = roadmap_.nearest(component, q);
    for (int i = 0; i < kPieces && near.distance > piece && !host.stopToken().stopRequested(); ++i) {
      const Pose from = roadmap_.nodes()[near.index].q;
      const auto clear = configuration_.clearPose(interpolate(from, q, piece / near.distance), gap);
      if (!clear) break;
      const double left = metric_.distance(*clear, q);
      if (left > near.distance - kProgress * piece) break;
      const double step = host.parameters()[ParameterId::GrowthStep];
      if (freeFraction(*query_, from, *clear, step, host.stopToken()) < 1.0) break;
      const auto node = roadmap_.addChild(near.index, {*clear, Author::Contact, roadmap_.nodes()[near.index].side});
      near = {node, left};
    }
  }
}

void HandFollower::observe(std::size_t edgesBefore, PlannerHost& host) {
  const double reach = longestEdge(edgesBefore);
  stepsWithoutGrowth_ = reach > 0.0 ? 0 : stepsWithoutGrowth_ + 1;
  tuned_ = host.parameters().integer(ParameterId::Tuning);
  if (tuned_ != 0) tuner_.observe({lastAuthor(), reach, contactClearance_});
}

void HandFollower::noteComputerTurn(double reach) {
  computersTurn_ = true;
  if (tuned_ != 0) tuner_.observe({Author::Computer, reach, 0.0});
}

std::optional<TuningReport> HandFollower::tuning() const {
  if (tuned_ == 0) return std::nullopt;
  return tuner_.report();
}

void HandFollower::pathFound(bool joined, double followed) {
  report_.joined = joined;
  report_.followed = followed;
}

}  // namespace glissade
