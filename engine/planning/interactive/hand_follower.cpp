#include "engine/planning/interactive/hand_follower.h"

#include <algorithm>

#include "engine/base/tolerances.h"
#include "engine/planning/automatic/tube_sampler.h"

namespace glissade {
namespace {

/// Configurations between the tree and the hand, for each one that the tree does not reach.
constexpr int kBetween = 8;
/// Deviation of these, in the distance that they bridge.
constexpr double kDeviation = 0.25;

}  // namespace

HandFollower::HandFollower(const Problem& problem, std::uint64_t seed, std::shared_ptr<ErodedWorlds> worlds)
    : AddTreePlanner(problem),
      stream_(seed, "between tree and hand"),
      contactSampler_(seed),
      configuration_(problem, std::move(worlds)),
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
    const QueryCounts freeing = configuration_.counts();
    counts_.queries.collision += freeing.collision;
    counts_.queries.distance += freeing.distance;
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

bool HandFollower::hasWork(const OperatorSample& sample, bool extras) const {
  return sample.q_device != shown_ || (extras && (contactSamplesLeft_ > 0 || betweenLeft_ > 0));
}

InteractionSettings HandFollower::settings(const ParameterValues& parameters) const {
  return settingsInForce(parameters, tuner_.settings());
}

void HandFollower::step(PlannerHost& host) {
  ++counts_.iterations;
  const auto sample = host.operatorSample();
  const bool moved = sample && sample->q_device != shown_;
  if (contactSamplesLeft_ > 0) {
    sampleContact(host);
  } else if (moved) {
    follow(sample->q_device, host);
  } else if (betweenLeft_ > 0) {
    sampleBetween(host);
  } else {
    passStep(Author::Operator);
  }
}

void HandFollower::follow(const Pose& q, PlannerHost& host) {
  ++counts_.operatorConfigurations;
  ++report_.shown;
  shown_ = q;
  betweenLeft_ = 0;
  if (!problem_.bounds.contains(q.position)) {
    passStep(Author::Operator);
    return;
  }
  const double gap = host.parameters()[ParameterId::ContactGap];
  const auto freed = configuration_.freed(q, gap);
  free_ = freed ? freed->q : q;
  if (!freed || freed->moved > 0.0) ++report_.collided;
  if (freed && freed->moved > 0.0) ++report_.movedToContact;
  way_.add(free_, freed ? freed->nearest : NearestObstacle(),
           freed ? freed->moved : ShownConfiguration::kMostMoved * metric_.radius());
  addTree(free_, Author::Operator, host);
  const bool reached = startTreeIsAt(free_);
  if (!reached) betweenLeft_ = kBetween;
  const InteractionSettings inForce = settings(host.parameters());
  if (!freed || freed->nearest.distance >= inForce.contactDistance) return;
  OperatorSample touching;
  touching.q_device = free_;
  touching.nearest = freed->nearest;
  contactClearance_ = freed->nearest.distance;
  contactSampler_.enter(touching, gap, host.parameters()[ParameterId::ContactRadius]);
  contactSamplesLeft_ = inForce.contactSamples;
}

bool HandFollower::startTreeIsAt(const Pose& q) const {
  return roadmap_.nearest(roadmap_.componentOf(startRoot_), q).distance <= tolerance::kDuplicate * metric_.radius();
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

void HandFollower::sampleBetween(PlannerHost& host) {
  --betweenLeft_;
  ++counts_.operatorConfigurations;
  const auto near = roadmap_.nearest(roadmap_.componentOf(startRoot_), free_);
  const Pose between = interpolate(roadmap_.nodes()[near.index].q, free_, stream_.uniform());
  const double deviation = std::max(way_.spread(), kDeviation * near.distance) * stream_.uniform();
  addTree(perturbed(between, deviation, metric_.radius(), problem_.bounds, stream_), Author::Operator, host);
  if (startTreeIsAt(free_)) betweenLeft_ = 0;
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
