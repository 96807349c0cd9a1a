#include "engine/planning/interactive/hand_partner.h"

#include <algorithm>
#include <limits>

#include "engine/planning/interactive/way_sampler.h"
#include "engine/planning/nearest_neighbours.h"

namespace glissade {
namespace {

/// Number of steps of the hand without growth after which the hand keeps only this share of its authority.
constexpr std::uint64_t kPatience = 400;
constexpr double kLeftInVain = 0.1;
/// Share of the computer's steps that grow the trees of the hand.
constexpr double kFollowersShare = 0.97;
/// Movement of the hand in a round, in radii of the object. Above the first value the next rounds are shorter, so that
/// the hand does not wait. Below the second one they are longer.
constexpr double kMostMovement = 0.05;
constexpr double kLittleMovement = 0.01;
/// Largest distance from the way of a path that runs along it, in radii of the object.
constexpr double kAlong = 0.2;
/// A path is attributed to the computer if a smaller share of its length runs along the way.
constexpr double kLeastFollowed = 0.1;
/// Share of the draws in the tube for members that slide, where the hand is always in contact.
constexpr double kSlidersShare = 0.5;

}  // namespace

HandPartner::HandPartner(const Problem& problem, std::uint64_t seed)
    : HandPartner(problem, seed, std::make_shared<ErodedWorlds>(problem.world)) {}

HandPartner::HandPartner(const Problem& problem, std::uint64_t seed, const std::shared_ptr<ErodedWorlds>& worlds)
    : HandPartner(problem, seed, worlds, std::make_unique<HandFollower>(problem, seed, worlds)) {}

HandPartner::HandPartner(const Problem& problem, std::uint64_t seed, std::shared_ptr<ErodedWorlds> worlds,
                         std::unique_ptr<HandFollower> follower)
    : problem_(problem),
      worlds_(std::move(worlds)),
      authorityStream_(seed, "authority"),
      follower_(follower.get()),
      planner_(std::move(follower), std::numeric_limits<std::uint64_t>::max(), nullptr) {}

bool HandPartner::takesTurn(PlannerHost& host) {
  preferred_->follow(problem_, host.semanticEdits());
  const auto sample = host.operatorSample();
  held_ = sample.has_value();
  if (!sample) return false;
  noteMovement(sample->q_device);
  beforeRound_ = sample->q_device;
  publish(host.parameters(), sample->hand);
  const bool covered = account_.covers();
  const bool handHasWork = follower_->hasWork(*sample, covered);
  const bool shown = follower_->way().size() > 0;
  const bool grows = shown && account_.stepsAreScarce();  // the computer's steps grow the hand's trees, too
  if (!handHasWork && !grows) return false;
  const double hands = handHasWork ? share(host.parameters()) : 0.0;
  for (;;) {
    if (authorityStream_.uniform() < hands) {
      follower_->setTurn(HandFollower::Turn::Hand);
      return true;
    }
    if (grows && authorityStream_.uniform() < kFollowersShare) {
      follower_->setTurn(HandFollower::Turn::Computer);
      return true;
    }
    if (prepaid_ == 0) return false;
    --prepaid_;
  }
}

/// The operator's share, 1 - alpha.
double HandPartner::share(const ParameterValues& parameters) const {
  const double share = 1.0 - follower_->settings(parameters).alpha;
  return follower_->stepsWithoutGrowth() > kPatience ? kLeftInVain * share : share;
}

/// Shortens the next rounds where the hand moved far during a round, as it does in lockstep.
void HandPartner::noteMovement(const Pose& q) {
  const std::uint64_t quantum = std::exchange(lastQuantum_, 0);
  if (quantum == 0) return;
  const double moved = problem_.metric().distance(q, beforeRound_) / problem_.world->objectRadius();
  if (moved > kMostMovement) {
    const double work = static_cast<double>(quantum) * kMostMovement / moved;
    mostWork_ = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(work));
  }
  if (moved < kLittleMovement) mostWork_ = std::min(kMostWork, 2 * mostWork_);
}

void HandPartner::publish(const ParameterValues& parameters, const std::optional<Pose>& hand) {
  const WayRecorder& way = follower_->way();
  if (way.size() == 0) return;
  const double hands = account_.covers() ? share(parameters) : 0.0;
  const bool known =
      board_->current() && published_ == way.version() && publishedHand_ == hand && board_->current()->share == hands;
  if (known) return;
  const InteractionSettings inForce = follower_->settings(parameters);
  published_ = way.version();
  publishedHand_ = hand;
  auto shown = std::make_shared<ShownWay>();
  shown->points = way.points();
  shown->push = way.push(hand);
  shown->contact = {inForce.contactSamples, inForce.contactDistance, parameters[ParameterId::ContactGap]};
  shown->spread = way.spread();
  shown->share = hands;
  shown->slidersShare = kSlidersShare * way.inContact();
  board_->publish(std::move(shown));
}

void HandPartner::turnDone(std::uint64_t work) {
  account_.charge(1, {work, work});
  account_.noteShown(follower_->handReport().shown);
}

void HandPartner::roundDone(const RoundOutcome& outcome) {
  lastQuantum_ = outcome.quantum;
  prepaid_ += outcome.turns - 1;
  const double shared = board_->current() ? board_->current()->share : 0.0;
  const double hands = shared * static_cast<double>(outcome.work);
  account_.charge(outcome.turns, {outcome.work, static_cast<std::uint64_t>(hands)});
  if (held_) follower_->noteComputerTurn(outcome.reach);
}

std::unique_ptr<ConfigurationSampler> HandPartner::sampler(std::unique_ptr<ConfigurationSampler> own,
                                                           std::uint64_t seed, bool slides) const {
  auto ofWay = std::make_unique<WaySampler>(problem_, std::move(own), seed, board_, slides);
  return std::make_unique<PreferredSampler>(std::move(ofWay), seed, preferred_);
}

void HandPartner::solved(const Path& path, bool shared) {
  const double followed = followedShare(path);
  follower_->pathFound(shared && followed >= kLeastFollowed, followed);
}

/// Share of the path's metric length that runs along the hand's way.
double HandPartner::followedShare(const Path& path) const {
  const Se3Metric metric = problem_.metric();
  NearestNeighbours way(metric);
  std::uint32_t index = 0;
  for (const ShownWay::Point& point : follower_->way().points()) way.add(index++, point.q);
  double all = 0.0;
  double along = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const Pose& from = path.points[i - 1].q;
    const Pose& to = path.points[i].q;
    const double length = metric.distance(from, to);
    const int pieces = 1 + static_cast<int>(length / (kAlong * metric.radius()));
    for (int piece = 0; piece < pieces; ++piece) {
      const auto near = way.nearest(interpolate(from, to, (piece + 0.5) / pieces));
      all += length / pieces;
      if (near && near->distance <= kAlong * metric.radius()) along += length / pieces;
    }
  }
  return all > 0.0 ? along / all : 0.0;
}

}  // namespace glissade
