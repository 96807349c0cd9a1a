#include "engine/planning/contact/interactive_contact_birrt.h"

#include <algorithm>
#include <cmath>

#include "engine/base/tolerances.h"
#include "engine/planning/path_certificate.h"

namespace glissade {
namespace {

/// Most configurations shot from one pose of an operator who does not move: five seconds at the pace of the paper's
/// machine. At today's pace more would add many useless nodes.
constexpr std::uint64_t kRestBudget = 200;

}  // namespace

InteractiveContactBirrt::InteractiveContactBirrt(const Problem& problem, std::uint64_t seed, OperatorUse operatorUse)
    : AddTreePlanner(problem),
      operatorUse_(operatorUse),
      authorityStream_(seed, "authority"),
      randomShooter_(problem, seed),
      contactSampler_(seed),
      contactFollower_(problem.world->objectRadius(), seed),
      trail_(problem),
      tuner_(problem.world->objectRadius()) {}

bool InteractiveContactBirrt::solve(PlannerHost& host) {
  while (!path_) {
    const std::size_t edgesBefore = roadmap_.edges().size();
    followHand(host);
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

/// The way of the hand is a tree, whoever has authority.
void InteractiveContactBirrt::followHand(PlannerHost& host) {
  if (operatorUse_ != OperatorUse::GuideContactAndTrail) return;
  if (const auto device = host.operatorSample()) trail_.follow(*device, roadmap_, *query_, host);
}

/// One pass of Algorithm 1; the numbers are its lines. Line 9 of the following passes is in solve().
void InteractiveContactBirrt::iterate(PlannerHost& host) {
  ++counts_.iterations;
  const InteractionSettings inForce = settingsInForce(host.parameters(), tuner_.settings());
  std::optional<OperatorSample> device;
  if (operatorUse_ != OperatorUse::None) device = host.operatorSample();  // line 2: found by the operator thread
  held_ = device.has_value();
  const double a = authorityStream_.uniform();  // line 3
  if (operatorUse_ == OperatorUse::ContactFirst && device && nearContact(*device, inForce.contactDistance)) {
    enterContactSampling(*device, host);
    contactSampling(host);
  } else if (operatorHasAuthority(a, inForce.alpha, device)) {  // line 4
    if (!nearContact(*device, inForce.contactDistance)) {       // line 5
      operatorShooter(*device, host);                           // lines 6, 7
    } else {
      enterContactSampling(*device, host);
      contactSampling(host);  // line 9
    }
  } else if (operatorUse_ == OperatorUse::GuideContactAndTrail && device && inForce.alpha <= 0.0) {
    passStep(Author::Operator);  // the operator is alone, and shows nothing new
  } else {
    randomShooter(host);  // lines 12, 13
  }
}

bool InteractiveContactBirrt::operatorHasAuthority(double a, double alpha,
                                                   const std::optional<OperatorSample>& device) {
  if (!device || a <= alpha) return false;
  if (operatorUse_ == OperatorUse::GuideContactAndTrail && !trail_.handHasMoved()) return false;
  if (device->moves != restingAt_) {
    restingAt_ = device->moves;
    usedAtRest_ = 0;
  }
  return usedAtRest_ < kRestBudget;
}

/// Line 5 with the comparison reversed: |P_o - P_n| < d. In collision there is no contact mode.
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
  contactSamplesLeft_ = settingsInForce(parameters, tuner_.settings()).contactSamples;
}

/// Passes the outcome of the step to the tuner, if a setting is automatic and a person holds the object.
void InteractiveContactBirrt::observeStep(std::size_t edgesBefore, PlannerHost& host) {
  tuned_ = operatorUse_ == OperatorUse::None ? 0 : host.parameters().integer(ParameterId::Tuning);
  if (tuned_ == 0 || !held_) return;
  tuner_.observe({lastAuthor(), longestEdge(edgesBefore), contactClearance_});
}

std::optional<TuningReport> InteractiveContactBirrt::tuning() const {
  if (tuned_ == 0) return std::nullopt;
  return tuner_.report();
}

InteractiveContactBirrt::HandWay InteractiveContactBirrt::handWay(PlannerHost& host) {
  while (trail_.longest()) {
    const HandTrail::Stretch& shown = *trail_.longest();
    const auto goal = std::find_if(goalRoots_.begin(), goalRoots_.end(),
                                   [&](Node root) { return roadmap_.connected(root, shown.end); });
    HandWay found;
    found.fromStart = roadmap_.connected(startRoot_, shown.end);
    found.toGoal = !found.fromStart && goal != goalRoots_.end();
    const Node begun = roadmap_.connected(shown.beginning, shown.end) ? shown.beginning : shown.end;
    const Node root = found.fromStart ? startRoot_ : found.toGoal ? *goal : begun;
    const auto pieces = [&](Node node) { return roadmap_.way(root, node)->edges.size(); };
    const Node farther = pieces(begun) > pieces(shown.end) ? begun : shown.end;
    const auto way = found.toGoal ? roadmap_.way(farther, root) : roadmap_.way(root, farther);
    found.points = pointsOf(*way);
    const auto refused = firstRefusedEdge(*query_, found.points, host.parameters(), host.stopToken());
    if (!refused) return found;
    if (way->edges.empty() || host.stopToken().stopRequested()) break;
    roadmap_.dropEdge(way->edges[refused->edge]);
  }
  return {};
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
    passStep(Author::Contact);
  }
}

void InteractiveContactBirrt::operatorShooter(const OperatorSample& device, PlannerHost& host) {
  ++counts_.operatorConfigurations;
  ++usedAtRest_;
  if (problem_.bounds.contains(device.q_device.position)) {
    addTree(device.q_device, Author::Operator, host);
  } else {
    passStep(Author::Operator);
  }
}

void InteractiveContactBirrt::randomShooter(PlannerHost& host) {
  ++counts_.randomConfigurations;
  addTree(randomShooter_.shoot(), Author::Computer, host);
}

}  // namespace glissade
