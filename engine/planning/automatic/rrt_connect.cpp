#include "engine/planning/automatic/rrt_connect.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/tolerances.h"
#include "engine/planning/goal_roots.h"
#include "engine/planning/path_certificate.h"

namespace glissade {
namespace {

/// Edges are sampled this much more finely after one failed its certificate, down to the finest.
constexpr double kRefinement = 0.5;
constexpr double kFinest = 0.125;
/// What the domain of a node grows and shrinks by (Jaillet et al. 2005).
constexpr double kDomainChange = 0.05;
constexpr double kGoalBias = 0.05;

}  // namespace

double searchRange(const Problem& problem, double share, double turnWeight) {
  return share *
         std::hypot(problem.bounds.diagonal().norm(), std::numbers::pi * turnWeight * problem.world->objectRadius());
}

RrtConnect::RrtConnect(const Problem& problem, std::uint64_t seed, const Options& options,
                       std::unique_ptr<ConfigurationSampler> sampler)
    : problem_(problem),
      options_(options),
      sampler_(std::move(sampler)),
      query_(problem.world->makeQuery()),
      goalStream_(seed, "goal bias"),
      metric_(options.turnWeight * problem.world->objectRadius()),
      roadmap_(metric_) {
  startRoot_ = roadmap_.addRoot({problem_.start, Author::Computer, TreeSide::Start});
  for (const Pose& q : goalRoots(problem_, *query_)) {
    goalRoots_.push_back(roadmap_.addRoot({q, Author::Computer, TreeSide::Goal}));
  }
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
  ++counts_.iterations;
  ++counts_.steps;
  ++counts_.randomConfigurations;
  if (options_.growth == Growth::Both) {
    growBoth(host);
  } else {
    growOne(host);
  }
}

/// A tree grows towards a random configuration, the nearest other one towards what it grew by.
void RrtConnect::growBoth(PlannerHost& host) {
  const std::vector<ComponentId> components = roadmap_.components();
  const ComponentId grown = components[turn_++ % components.size()];
  const auto node = grow(grown, sampler_->draw(), host);
  if (!node || components.size() < 2 || host.stopToken().stopRequested()) return;
  connect(nearestOther(grown, roadmap_.nodes()[*node].q), *node, host);
}

/// The tree grows towards a random configuration, or now and then all the way to the other end.
void RrtConnect::growOne(PlannerHost& host) {
  const std::vector<Node> starts{startRoot_};
  const bool fromStart = options_.growth == Growth::FromStart;
  const std::vector<Node>& roots = fromStart ? starts : goalRoots_;
  const std::vector<Node>& ends = fromStart ? goalRoots_ : starts;
  const ComponentId grown = roadmap_.componentOf(roots[turn_++ % roots.size()]);
  const double draw = goalStream_.uniform() / kGoalBias;
  if (draw >= 1.0) {
    grow(grown, sampler_->draw(), host);
    return;
  }
  const Node end = ends[static_cast<std::size_t>(draw * static_cast<double>(ends.size()))];
  if (roadmap_.componentOf(end) != grown) connect(grown, end, host);
}

std::optional<RrtConnect::Node> RrtConnect::grow(ComponentId component, const Pose& q, PlannerHost& host) {
  const auto near = roadmap_.nearest(component, q);
  if (near.distance < tolerance::kSameConfiguration * metric_.radius() || near.distance > domains_[near.index]) {
    return std::nullopt;
  }
  const Extension extension = extend(near.index, q, host);
  adapt(near.index, extension.outcome != Outcome::Trapped);
  if (extension.outcome == Outcome::Reached) return addChild(near.index, q);
  return extension.outcome == Outcome::Advanced ? std::optional<Node>(extension.node) : std::nullopt;
}

RrtConnect::ComponentId RrtConnect::nearestOther(ComponentId grown, const Pose& q) const {
  ComponentId best = grown;
  double least = std::numeric_limits<double>::infinity();
  for (const ComponentId component : roadmap_.components()) {
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
  return roadmap_.addChild(parent, {q, Author::Computer, roadmap_.nodes()[parent].side});
}

/// Grows from a node towards q by at most the range; less where something is in the way. Where q
/// itself is within reach nothing is added: q may be a node already.
RrtConnect::Extension RrtConnect::extend(Node from, const Pose& q, PlannerHost& host) {
  const Pose origin = roadmap_.nodes()[from].q;
  const double distance = metric_.distance(origin, q);
  const double length = std::min(distance, options_.range);
  const Pose target = length < distance ? interpolate(origin, q, length / distance) : q;
  const double step = host.parameters()[ParameterId::GrowthStep] * refinement_;
  const double free = freeFraction(*query_, origin, target, step, host.stopToken());
  if (free >= 1.0 && length == distance) return {Outcome::Reached, from};
  double t = 1.0;
  if (free < 1.0) {
    const double grid = tolerance::kGuidedExtensionStep * metric_.radius();
    t = std::floor(free * length / grid) * grid / length;
    if (t * length < grid) return {Outcome::Trapped, from};
  }
  const Node node = addChild(from, t < 1.0 ? interpolate(origin, target, t) : target);
  return {free < 1.0 ? Outcome::Trapped : Outcome::Advanced, node};
}

void RrtConnect::connect(ComponentId component, Node target, PlannerHost& host) {
  const Pose q = roadmap_.nodes()[target].q;
  Node at = roadmap_.nearest(component, q).index;
  for (;;) {
    const Extension extension = extend(at, q, host);
    if (extension.outcome == Outcome::Reached) {
      roadmap_.join(at, target);
      joined_ = true;
    }
    if (extension.outcome != Outcome::Advanced || host.stopToken().stopRequested()) return;
    at = extension.node;
  }
}

void RrtConnect::adapt(Node node, bool grew) {
  if (options_.domain <= 0.0) return;
  const double first = options_.domain * options_.range;
  double& domain = domains_[node];
  if (grew) {
    domain *= 1.0 + kDomainChange;
  } else if (std::isinf(domain)) {
    domain = first;
  } else {
    domain = std::max(options_.range, domain * (1.0 - kDomainChange));
  }
}

/// Certifies the way from start to goal once there is one.
void RrtConnect::deliverPath(PlannerHost& host) {
  joined_ = false;
  for (const Node goal : goalRoots_) {
    const auto way = roadmap_.way(startRoot_, goal);
    if (!way) continue;
    Path path;
    for (const Node node : way->nodes) path.points.push_back({roadmap_.nodes()[node].q, Author::Computer});
    path.certificate = certifyPath(*query_, path.points, host.parameters(), host.stopToken());
    if (path.certificate.status == CertificateStatus::Certified) {
      path_ = std::move(path);
      return;
    }
    const std::size_t refused = path.certificate.edge;
    joined_ = true;
    if (host.stopToken().stopRequested()) return;
    roadmap_.dropEdge(way->edges[refused]);
    refinement_ = std::max(kFinest, refinement_ * kRefinement);
  }
}

void RrtConnect::updateCounts() {
  counts_.nodes = roadmap_.nodes().size();
  counts_.edges = roadmap_.directedEdgeCount();
  counts_.droppedEdges = roadmap_.droppedEdges().size();
  counts_.queries = query_->counts();
}

}  // namespace glissade
