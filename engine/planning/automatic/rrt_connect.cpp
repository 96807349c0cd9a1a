#include "engine/planning/automatic/rrt_connect.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/tolerances.h"

namespace glissade {
namespace {

/// Factor of the sampling step on edges after an edge failed its certificate, and its lower bound.
constexpr double kRefinement = 0.5;
constexpr double kFinest = 0.125;
/// Relative change of a node's domain when it grows or shrinks (Jaillet et al. 2005).
constexpr double kDomainChange = 0.05;
constexpr double kGoalBias = 0.05;
/// Factor of the range for the first draws, where Options::longDraws asks for it.
constexpr double kLong = 10.0;
/// Long draws go on while at least this share of their extensions is free; the share is asked from this number on.
constexpr double kLeastFree = 0.1;
constexpr std::uint64_t kLongTrials = 100;
/// Share of the range by which each extension of a sliding connection has to come nearer.
constexpr double kApproach = 0.2;

}  // namespace

double searchRange(const Problem& problem, double share, double turnWeight) {
  return share *
         std::hypot(problem.bounds.diagonal().norm(), std::numbers::pi * turnWeight * problem.world->objectRadius());
}

RrtConnect::RrtConnect(const Problem& problem, std::uint64_t seed, const Options& options,
                       std::unique_ptr<ConfigurationSampler> sampler)
    : TreePlanner(problem, Se3Metric(options.turnWeight * problem.world->objectRadius())),
      options_(options),
      range_(options.range),
      sampler_(std::move(sampler)),
      goalStream_(seed, "goal bias") {
  if (options_.slides) sliding_.emplace(*query_, problem_.bounds, metric_, range_);
  addGoalRoots();
  for (const RoadmapNode& root : roadmap_.nodes()) boxOf(root.side).extend(root.q.position);
  domains_.assign(roadmap_.nodes().size(), std::numeric_limits<double>::infinity());
  updateCounts();
}

bool RrtConnect::solve(PlannerHost& host) {
  while (!path_) {
    iterate(host);
    if (joined_) deliverPath(host);
    updateCounts();
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

void RrtConnect::iterate(PlannerHost& host) {
  range_ = drawsLong() ? kLong * options_.range : options_.range;
  ++counts_.iterations;
  ++counts_.steps;
  ++counts_.randomConfigurations;
  if (options_.growth == Growth::Both) {
    growBoth(host);
  } else {
    growOne(host);
  }
}

bool RrtConnect::drawsLong() const {
  if (counts_.iterations >= options_.longDraws) return false;
  return longTried_ < kLongTrials || static_cast<double>(longFree_) >= kLeastFree * static_cast<double>(longTried_);
}

/// One tree grows towards a random configuration; the nearest other tree grows towards its new node.
void RrtConnect::growBoth(PlannerHost& host) {
  const std::vector<ComponentId> components = roadmap_.components();
  const ComponentId grown = components[turn_++ % components.size()];
  const auto node = grow(grown, draw(grown), host);
  if (!node || components.size() < 2 || host.stopToken().stopRequested()) return;
  connect(nearestOther(grown, roadmap_.nodes()[*node].q), *node, host);
}

/// The tree grows towards a random configuration, or with a small probability all the way to the other end.
void RrtConnect::growOne(PlannerHost& host) {
  const std::vector<Node> starts{startRoot_};
  const bool fromStart = options_.growth == Growth::FromStart;
  const std::vector<Node>& roots = fromStart ? starts : goalRoots_;
  const std::vector<Node>& ends = fromStart ? goalRoots_ : starts;
  const ComponentId grown = roadmap_.componentOf(roots[turn_++ % roots.size()]);
  const double chance = goalStream_.uniform() / kGoalBias;
  if (chance >= 1.0) {
    grow(grown, draw(grown), host);
    return;
  }
  author_ = Author::Computer;
  const Node end = ends[static_cast<std::size_t>(chance * static_cast<double>(ends.size()))];
  if (roadmap_.componentOf(end) != grown) connect(grown, end, host);
}

Pose RrtConnect::draw(ComponentId tree) {
  const Pose q = sampler_->draw(boxOf(tree));
  author_ = sampler_->author();
  return q;
}

std::optional<RrtConnect::Node> RrtConnect::grow(ComponentId component, const Pose& q, PlannerHost& host) {
  const auto near = roadmap_.nearest(component, q);
  if (near.distance < tolerance::kSameConfiguration * metric_.radius() || near.distance > domains_[near.index]) {
    return std::nullopt;
  }
  const Extended extended = extend(near.index, q, host);
  const bool grew = extended.progress == Progress::Reached || extended.progress == Progress::Advanced;
  if (range_ > options_.range) {
    ++longTried_;
    if (grew) ++longFree_;
  }
  adapt(near.index, grew);
  if (extended.progress == Progress::Reached) return addChild(near.index, q);
  const bool slid = sliding_ && extended.progress == Progress::Blocked;
  return slid || extended.progress == Progress::Advanced ? std::optional<Node>(extended.node) : std::nullopt;
}

RrtConnect::ComponentId RrtConnect::nearestOther(ComponentId grown, const Pose& q) const {
  const std::vector<ComponentId> components = roadmap_.components();
  if (components.size() == 2) return components[components.front() == grown ? 1 : 0];
  ComponentId best = grown;
  double least = std::numeric_limits<double>::infinity();
  for (const ComponentId component : components) {
    if (component == grown) continue;
    const double distance = roadmap_.nearest(component, q).distance;
    if (distance >= least) continue;
    least = distance;
    best = component;
  }
  return best;
}

RrtConnect::Node RrtConnect::addChild(Node parent, const Pose& q) {
  domains_.push_back(std::numeric_limits<double>::infinity());
  sampler_->grew(q, *query_);
  const TreeSide side = roadmap_.nodes()[parent].side;
  boxOf(side).extend(q.position);
  return roadmap_.addChild(parent, {q, author_, side});
}

/// Grows from a node towards q by at most the range, or less where an obstacle blocks. Adds no node where q itself is
/// within reach, because q may be a node already.
RrtConnect::Extended RrtConnect::extend(Node from, const Pose& q, PlannerHost& host) {
  const double grid = tolerance::kGuidedExtensionStep * metric_.radius();
  const double step = host.parameters()[ParameterId::GrowthStep] * refinement_;
  const ExtensionRule rule{step, grid, grid, range_};
  const Extension grown = extension(from, q, metric_.distance(roadmap_.nodes()[from].q, q), rule, host);
  const bool blocked = grown.progress == Progress::Blocked || grown.progress == Progress::Trapped;
  if (sliding_ && blocked) return slideOn(from, q, step, host.stopToken());
  const bool adds = grown.progress == Progress::Advanced || grown.progress == Progress::Blocked;
  return {grown.progress, adds ? addChild(from, grown.end) : from};
}

RrtConnect::Extended RrtConnect::slideOn(Node from, const Pose& q, double step, const StopToken& stop) {
  const Pose origin = roadmap_.nodes()[from].q;
  const double distance = metric_.distance(origin, q);
  const Pose target = distance > range_ ? interpolate(origin, q, range_ / distance) : q;
  const auto end = sliding_->slide(from, origin, target, step, stop);
  if (!end) return {Progress::Trapped, from};
  const Node child = addChild(from, *end);
  sliding_->keep(from, child);
  return {Progress::Blocked, child};
}

void RrtConnect::connect(ComponentId component, Node target, PlannerHost& host) {
  const Pose q = roadmap_.nodes()[target].q;
  auto near = roadmap_.nearest(component, q);
  for (;;) {
    const Extended extended = extend(near.index, q, host);
    if (extended.progress == Progress::Reached) {
      roadmap_.join(near.index, target);
      joined_ = true;
    }
    const bool slid = sliding_ && extended.progress == Progress::Blocked;
    if ((!slid && extended.progress != Progress::Advanced) || host.stopToken().stopRequested()) return;
    const double left = metric_.distance(roadmap_.nodes()[extended.node].q, q);
    if (slid && left > near.distance - kApproach * range_) return;
    near = {extended.node, left};
  }
}

void RrtConnect::adapt(Node node, bool grew) {
  if (options_.domain <= 0.0) return;
  const double first = options_.domain * range_;
  double& domain = domains_[node];
  if (grew) {
    domain *= 1.0 + kDomainChange;
  } else if (std::isinf(domain)) {
    domain = first;
  } else {
    domain = std::max(range_, domain * (1.0 - kDomainChange));
  }
}

void RrtConnect::deliverPath(PlannerHost& host) {
  joined_ = false;
  for (const Node goal : goalRoots_) {
    const Delivery delivery = deliverWay(goal, host);
    if (delivery == Delivery::NoWay) continue;
    if (delivery == Delivery::Delivered) return;
    joined_ = true;
    if (delivery == Delivery::Stopped) return;
    refinement_ = std::max(kFinest, refinement_ * kRefinement);
  }
}

}  // namespace glissade
