#include "engine/planning/interactive/hand_follower.h"

#include <algorithm>
#include <cmath>

#include "engine/base/tolerances.h"
#include "engine/planning/automatic/portfolio.h"
#include "engine/planning/automatic/tube_sampler.h"
#include "engine/planning/interactive/query_sum.h"

namespace glissade {
namespace {

/// Nearer to it, a configuration of the hand is the same as another. In radii of the object.
constexpr double kSame = 0.05;
/// Steps about a gap of the way, for each movement of the hand; and of a search until it begins with another target.
constexpr int kGapSamples = 8;
constexpr std::uint64_t kGapSteps = 100;  // the first time; the next ones follow Luby's sequence
/// Configurations near the one that is shown, where that cannot be retracted.
constexpr int kAttempts = 8;
/// Share of the computer's steps that search a gap of the way, while there is one.
constexpr double kGapShare = 0.5;
/// Deviation of these, in the distance that they bridge.
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
    counts_.queries += pastGaps_;
    if (gap_) counts_.queries += gap_->queries();
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

bool HandFollower::hasWork(const OperatorSample& sample, bool extras) const {
  return movedFar(sample.q_device) || (extras && (contactSamplesLeft_ > 0 || (gapSamplesLeft_ > 0 && lags())));
}

bool HandFollower::movedFar(const Pose& q) const { return metric_.distance(q, shown_) >= kSame * metric_.radius(); }

InteractionSettings HandFollower::settings(const ParameterValues& parameters) const {
  return settingsInForce(parameters, tuner_.settings());
}

void HandFollower::step(PlannerHost& host) {
  ++counts_.iterations;
  const auto sample = host.operatorSample();
  const bool moved = sample && movedFar(sample->q_device);
  const bool gap = gapSamplesLeft_ > 0 && lags();
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
  const auto freed = configuration_.freed(q, gap);
  free_ = freed ? freed->q : q;
  if (!freed || freed->moved > 0.0) ++report_.collided;
  if (freed && freed->moved > 0.0) ++report_.movedToContact;
  const std::uint64_t before = way_.version();
  way_.add(free_, freed ? freed->nearest : NearestObstacle(),
           freed ? freed->moved : ShownConfiguration::kMostMoved * metric_.radius());
  addTree(free_, Author::Operator, host);
  slide(free_, host);
  if (startTreeIsAt(free_)) {
    reached_ = way_.version();
    return;
  }
  noteReached();
  gapSamplesLeft_ = kGapSamples;
  const InteractionSettings inForce = settings(host.parameters());
  if (way_.version() == before || !freed || freed->nearest.distance >= inForce.contactDistance) return;
  OperatorSample touching;
  touching.q_device = free_;
  touching.nearest = freed->nearest;
  contactClearance_ = freed->nearest.distance;
  contactSampler_.enter(touching, gap, host.parameters()[ParameterId::ContactRadius]);
  contactSamplesLeft_ = inForce.contactSamples;
}

/// Goes on along the way as far as the start's tree has got by the nodes since the last time.
void HandFollower::noteReached() {
  const auto& points = way_.points();
  const std::uint64_t first = way_.version() - points.size();
  reached_ = std::max(reached_, first);
  const ComponentId start = roadmap_.componentOf(startRoot_);
  for (; nodesSeen_ < roadmap_.nodes().size(); ++nodesSeen_) {
    if (roadmap_.componentOf(static_cast<Node>(nodesSeen_)) != start) continue;
    const Pose& q = roadmap_.nodes()[nodesSeen_].q;
    for (std::uint64_t i = way_.version(); i > reached_; --i) {
      if (metric_.distance(points[i - 1 - first].q, q) <= kSame * metric_.radius()) reached_ = i;
    }
  }
}

bool HandFollower::startTreeIsAt(const Pose& q) const {
  return roadmap_.nearest(roadmap_.componentOf(startRoot_), q).distance <= kSame * metric_.radius();
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
  if (!gap_ || gap_->steps() >= kGapSteps * lubyTerm(gapsInVain_) || startTreeIsAt(gap_->target())) beginGap();
  if (!gap_) {
    sampleGap(host);
    return;
  }
  passStep(Author::Operator);
  const auto bridge = gap_->step(host);
  if (!bridge) return;
  Node at = gapFrom_;
  for (std::size_t i = 1; i < bridge->size(); ++i) {
    at = roadmap_.addChild(at, {(*bridge)[i], Author::Operator, roadmap_.nodes()[gapFrom_].side});
  }
  endGap();
  gapsInVain_ = 0;
  noteReached();
}

void HandFollower::beginGap() {
  endGap();
  ++gapsInVain_;
  const auto& points = way_.points();
  const std::uint64_t first = way_.version() - points.size();
  std::vector<Pose> targets;
  for (std::uint64_t i = reached_; i < way_.version(); ++i) {
    if (points[i - first].nearest.distance > 0.0) targets.push_back(points[i - first].q);
  }
  if (targets.empty()) return;
  // The latest ones more often: that is where the hand waits.
  const double late = std::sqrt(stream_.uniform());
  const Pose& target = targets[static_cast<std::size_t>(late * static_cast<double>(targets.size()))];
  const auto near = roadmap_.nearest(roadmap_.componentOf(startRoot_), target);
  if (near.distance <= kSame * metric_.radius()) return;
  gapFrom_ = near.index;
  const double deviation = std::max(way_.spread(), kDeviation * near.distance);
  gap_.emplace(problem_, roadmap_.nodes()[near.index].q, target, deviation, stream_.bits(), worlds_);
}

/// Where no configuration beyond the gap is free: one near a point of the way, or between that and the tree.
void HandFollower::sampleGap(PlannerHost& host) {
  const auto& points = way_.points();
  const std::uint64_t missing = std::min<std::uint64_t>(way_.version() - reached_, points.size());
  const std::uint64_t back = 1 + static_cast<std::uint64_t>(stream_.uniform() * static_cast<double>(missing));
  const Pose& target = points[points.size() - std::min(back, missing)].q;
  const auto near = roadmap_.nearest(roadmap_.componentOf(startRoot_), target);
  const Pose between = interpolate(roadmap_.nodes()[near.index].q, target, std::sqrt(stream_.uniform()));
  const double deviation = std::max(kSame * metric_.radius(), kDeviation * near.distance) * stream_.uniform();
  const Pose q = perturbed(between, deviation, metric_.radius(), problem_.bounds, stream_);
  addTree(q, Author::Operator, host);
  slide(q, host);
  noteReached();
}

void HandFollower::endGap() {
  if (!gap_) return;
  pastGaps_ += gap_->queries();
  gap_.reset();
}

void HandFollower::sampleForComputer(PlannerHost& host) {
  if (lags() && stream_.uniform() < kGapShare) {
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
  noteReached();
}

/// Where a component was blocked on its way to q, it goes on in contact: a short motion towards q is retracted from
/// what it runs into, as long as that brings it nearer.
void HandFollower::slide(const Pose& q, PlannerHost& host) {
  const double piece = kPiece * metric_.radius();
  const double gap = host.parameters()[ParameterId::ContactGap];
  for (const ComponentId component : roadmap_.components()) {
    auto near = roadmap_.nearest(component, q);
    for (int i = 0; i < kPieces && near.distance > piece && !host.stopToken().stopRequested(); ++i) {
      const Pose from = roadmap_.nodes()[near.index].q;
      const auto freed = configuration_.freedPose(interpolate(from, q, piece / near.distance), gap);
      if (!freed) break;
      const double left = metric_.distance(*freed, q);
      if (left > near.distance - kProgress * piece) break;
      const double step = host.parameters()[ParameterId::GrowthStep];
      if (freeFraction(*query_, from, *freed, step, host.stopToken()) < 1.0) break;
      const auto node = roadmap_.addChild(near.index, {*freed, Author::Contact, roadmap_.nodes()[near.index].side});
      near = {node, left};
    }
  }
}

void HandFollower::observe(std::size_t edgesBefore, PlannerHost& host) {
  const double reach = longestEdge(edgesBefore);
  stepsInVain_ = reach > 0.0 ? 0 : stepsInVain_ + 1;
  tuned_ = host.parameters().integer(ParameterId::Tuning);
  if (tuned_ != 0) tuner_.observe({lastAuthor(), reach, contactClearance_});
}

void HandFollower::computerHadTurn(double reach) {
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
