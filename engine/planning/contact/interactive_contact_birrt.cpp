#include "engine/planning/contact/interactive_contact_birrt.h"

#include <algorithm>
#include <cmath>

#include "engine/base/tolerances.h"

namespace glissade {
namespace {

/// Configurations shot from one pose of an operator who does not move: five seconds at the pace of
/// the paper's machine. More would only flood the roadmap at today's pace.
constexpr std::uint64_t kRestBudget = 200;

}  // namespace

InteractiveContactBirrt::InteractiveContactBirrt(const Problem& problem, std::uint64_t seed, OperatorUse operatorUse)
    : TreePlanner(problem, problem.metric()),
      operatorUse_(operatorUse),
      authorityStream_(seed, "authority"),
      randomShooter_(problem, seed),
      contactSampler_(seed),
      contactFollower_(problem.world->objectRadius(), seed),
      tuner_(problem.world->objectRadius()) {
  addGoalRoots();
  updateCounts();
}

bool InteractiveContactBirrt::solve(PlannerHost& host) {
  while (!path_) {
    const std::size_t edgesBefore = roadmap_.edges().size();
    if (contactSamplesLeft_ > 0) {
      contactSampling(host);
    } else {
      iterate(host);
    }
    deliverPath(host);
    observeStep(edgesBefore, host);
    updateCounts();
    if (!host.afterStep()) break;
  }
  return path_.has_value();
}

/// One pass of Algorithm 1; the numbers are its lines. Lines 9 of the following passes are in solve().
void InteractiveContactBirrt::iterate(PlannerHost& host) {
  ++counts_.iterations;
  const InteractionSettings inForce = settings(host.parameters());
  std::optional<OperatorSample> device;
  if (operatorUse_ != OperatorUse::None) device = host.operatorSample();  // 2: found by the operator thread
  held_ = device.has_value();
  const double a = authorityStream_.uniform();  // 3
  if (operatorUse_ == OperatorUse::ContactFirst && device && nearContact(*device, inForce.contactDistance)) {
    enterContactSampling(*device, host);
    contactSampling(host);
  } else if (operatorHasAuthority(a, inForce.alpha, device)) {  // 4
    if (!nearContact(*device, inForce.contactDistance)) {       // 5
      operatorShooter(*device, host);                           // 6, 7
    } else {
      enterContactSampling(*device, host);
      contactSampling(host);  // 9
    }
  } else {
    randomShooter(host);  // 12, 13
  }
}

bool InteractiveContactBirrt::operatorHasAuthority(double a, double alpha,
                                                   const std::optional<OperatorSample>& device) {
  if (!device || a <= alpha) return false;
  if (device->moves != restingAt_) {
    restingAt_ = device->moves;
    usedAtRest_ = 0;
  }
  return usedAtRest_ < kRestBudget;
}

/// Line 5, read the other way round: |P_o - P_n| < d. In collision there is no contact mode.
bool InteractiveContactBirrt::nearContact(const OperatorSample& device, double contactDistance) const {
  if (operatorUse_ == OperatorUse::Guide) return false;
  const double distance = device.nearest.distance;
  return distance > 0.0 && distance < contactDistance;
}

void InteractiveContactBirrt::enterContactSampling(const OperatorSample& device, PlannerHost& host) {
  const ParameterValues& parameters = host.parameters();
  contactClearance_ = device.nearest.distance;
  const double gap = parameters[ParameterId::ContactGap];
  const double reach = parameters[ParameterId::ContactRadius];
  if (operatorUse_ == OperatorUse::GuideAndFollow) {
    contactFollower_.enter(device, gap, reach);
  } else {
    contactSampler_.enter(device, gap, reach);
  }
  contactSamplesLeft_ = settings(parameters).contactSamples;
}

/// The user's values, but what sets itself.
InteractionSettings InteractiveContactBirrt::settings(const ParameterValues& parameters) const {
  const int tuned = parameters.integer(ParameterId::Tuning);
  InteractionSettings inForce = tuner_.settings();
  if ((tuned & kTunedAlpha) == 0) inForce.alpha = parameters[ParameterId::Alpha];
  if ((tuned & kTunedContactSamples) == 0) inForce.contactSamples = parameters.integer(ParameterId::ContactSamples);
  if ((tuned & kTunedContactDistance) == 0) inForce.contactDistance = parameters[ParameterId::ContactDistance];
  return inForce;
}

/// Lets the tuner know what the step brought, where it has anything to set and somebody holds the object.
void InteractiveContactBirrt::observeStep(std::size_t edgesBefore, PlannerHost& host) {
  tuned_ = operatorUse_ == OperatorUse::None ? 0 : host.parameters().integer(ParameterId::Tuning);
  if (tuned_ == 0 || !held_) return;
  tuner_.observe({authority_, longestEdge(edgesBefore), contactClearance_});
}

/// Of the edges from this one on; 0 where there is none.
double InteractiveContactBirrt::longestEdge(std::size_t first) const {
  double longest = 0.0;
  for (std::size_t i = first; i < roadmap_.edges().size(); ++i) {
    const RoadmapEdge& edge = roadmap_.edges()[i];
    longest = std::max(longest, metric_.distance(roadmap_.nodes()[edge.from].q, roadmap_.nodes()[edge.to].q));
  }
  return longest;
}

std::optional<TuningReport> InteractiveContactBirrt::tuning() const {
  if (tuned_ == 0) return std::nullopt;
  return tuner_.report();
}

void InteractiveContactBirrt::contactSampling(PlannerHost& host) {
  --contactSamplesLeft_;
  ++counts_.contactConfigurations;
  ++usedAtRest_;
  const bool follows = operatorUse_ == OperatorUse::GuideAndFollow;
  const Pose q = follows ? contactFollower_.sample(*query_) : contactSampler_.sample();
  if (problem_.bounds.contains(q.position)) {
    addTree(q, Author::Contact, host);
  } else {
    ++counts_.steps;
    authority_ = Author::Contact;
  }
}

void InteractiveContactBirrt::operatorShooter(const OperatorSample& device, PlannerHost& host) {
  ++counts_.operatorConfigurations;
  ++usedAtRest_;
  if (problem_.bounds.contains(device.q_device.position)) {
    addTree(device.q_device, Author::Operator, host);
  } else {
    ++counts_.steps;
    authority_ = Author::Operator;
  }
}

void InteractiveContactBirrt::randomShooter(PlannerHost& host) {
  ++counts_.randomConfigurations;
  addTree(randomShooter_.shoot(), Author::Computer, host);
}

/// Add_Tree(q): one step of the paper's BiRRT. Every component grows straight towards q as far as it
/// is free; then the new nodes are connected with each other.
void InteractiveContactBirrt::addTree(const Pose& q, Author author, PlannerHost& host) {
  ++counts_.steps;
  authority_ = author;
  std::vector<Node> added;
  std::optional<Node> reached;
  for (const ComponentId component : roadmap_.components()) {
    if (const auto node = extend(component, q, author, reached, host)) added.push_back(*node);
    if (host.stopToken().stopRequested()) return;
  }
  connect(added, host);
}

/// Extends one component towards q. `reached` is the node at q itself once some component got there:
/// the next one that gets there joins it instead of adding q again.
std::optional<InteractiveContactBirrt::Node> InteractiveContactBirrt::extend(ComponentId component, const Pose& q,
                                                                             Author author,
                                                                             std::optional<Node>& reached,
                                                                             PlannerHost& host) {
  const auto near = roadmap_.nearest(component, q);
  const double radius = problem_.world->objectRadius();
  const double same = author == Author::Computer ? tolerance::kSameConfiguration : tolerance::kDuplicate;
  if (near.distance < same * radius) return near.index;  // as good as q itself: worth connecting
  const double grid = author == Author::Computer ? host.parameters()[ParameterId::ExtensionStep]
                                                 : tolerance::kGuidedExtensionStep * radius;
  const ExtensionRule rule{host.parameters()[ParameterId::GrowthStep], grid, 0.5 * grid};
  const Extension grown = extension(near.index, q, near.distance, rule, host);
  const bool whole = grown.progress == Progress::Reached;
  if (whole && reached) {
    roadmap_.join(near.index, *reached);
    return std::nullopt;
  }
  if (grown.progress == Progress::Trapped || (!whole && isDuplicate(component, grown.end, author))) return std::nullopt;
  const Node node = roadmap_.addChild(near.index, {grown.end, author, roadmap_.nodes()[near.index].side});
  if (whole) reached = node;
  return node;
}

bool InteractiveContactBirrt::isDuplicate(ComponentId component, const Pose& q, Author author) const {
  if (author == Author::Computer) return false;
  return roadmap_.nearest(component, q).distance < tolerance::kDuplicate * problem_.world->objectRadius();
}

void InteractiveContactBirrt::connect(const std::vector<Node>& added, PlannerHost& host) {
  const double step = host.parameters()[ParameterId::GrowthStep];
  for (std::size_t i = 0; i < added.size(); ++i) {
    for (std::size_t j = i + 1; j < added.size(); ++j) {
      if (roadmap_.connected(added[i], added[j])) continue;
      const Pose& from = roadmap_.nodes()[added[i]].q;
      const Pose& to = roadmap_.nodes()[added[j]].q;
      if (freeFraction(*query_, from, to, step, host.stopToken()) >= 1.0) {
        roadmap_.join(added[i], added[j]);
      }
    }
  }
}

/// An edge that cannot be certified is dropped and the search goes on.
void InteractiveContactBirrt::deliverPath(PlannerHost& host) {
  for (const Node goal : goalRoots_) {
    const Delivery delivery = deliverWay(goal, host);
    if (delivery == Delivery::Delivered || delivery == Delivery::Stopped) return;
  }
}

}  // namespace glissade
