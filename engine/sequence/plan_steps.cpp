#include "engine/sequence/plan_steps.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "engine/fits/fit_thread.h"
#include "engine/sequence/removal_directions.h"

namespace glissade {
namespace {

/// Turns in the thread of a body of the step, along this path.
double turnsIn(const ThreadRule& rule, const RigidBody& body, const RigidBody& other,
               const std::vector<PathPoint>& path) {
  std::vector<Pose> configurations;
  const Pose X_PB = inverse(path.front().q) * body.X_WB;
  for (const PathPoint& point : path) configurations.push_back(point.q * X_PB);
  return std::abs(turnsWhileEngaged(ThreadPair(rule, *body.mesh, other), configurations));
}

bool needsTool(std::size_t body, const BodySet& present, const SequenceQuestion& question) {
  if (question.tools.empty() || question.tools[body].empty()) return false;
  if (question.joints == nullptr || !question.joints->isScrewedTogether(body)) return true;
  return !question.joints->opened({body}, present).empty();
}

/// The direction of the body's joint, else an axis of the world that nobody forbids.
Vector3 flexibleDirection(std::size_t body, const SequenceQuestion& question) {
  std::vector<Vector3> directions;
  for (const Joint& joint : question.joints->joints()) {
    if (joint.kind == JointKind::Flexible && joint.body == body) directions.insert(directions.begin(), joint.direction);
  }
  for (const Eigen::Index axis : {2, 0, 1}) {
    for (const double side : {1.0, -1.0}) directions.push_back(side * Vector3::Unit(axis));
  }
  const std::vector<Vector3> forbidden = question.rules.forbiddenTo({body});
  const auto allowed = std::find_if(directions.begin(), directions.end(),
                                    [&](const Vector3& each) { return !isForbidden(each, forbidden); });
  return allowed == directions.end() ? directions.front() : *allowed;
}

}  // namespace

std::vector<BodyId> idsOf(const BodyGroup& bodies, const AssembledProduct& product) {
  std::vector<BodyId> ids;
  for (const std::size_t body : bodies) ids.push_back(product.bodies[body].id);
  return ids;
}

BodyGroup groupOf(const StepMotion& motion, const AssembledProduct& product) {
  BodyGroup group = product.indicesOf(motion.bodies());
  std::sort(group.begin(), group.end());
  return group;
}

std::vector<std::size_t> heldBy(const BodyGroup& group, const BodySet& present, const OrderRules& rules,
                                bool knowledgeToo) {
  const BodySet others = without(present, group);
  std::vector<std::size_t> holding;
  for (const OrderRule& rule : rules.before) {
    const bool counts = (rule.demanded || knowledgeToo) && others[rule.first];
    if (counts && std::binary_search(group.begin(), group.end(), rule.then)) holding.push_back(rule.first);
  }
  return holding;
}

BodyGroup heldByJoints(const BodyGroup& group, const BodySet& present, const SequenceQuestion& question, bool strict) {
  if (question.joints == nullptr) return {};
  return question.joints->holders(question.joints->holding(group, present, strict), group, present);
}

std::vector<StepViolation> violationsOf(const BodyGroup& group, const BodySet& present, const BodyGroup& falling,
                                        std::size_t number, const SequenceQuestion& question) {
  std::vector<StepViolation> violations;
  const auto add = [&](StepViolation::Rule rule, BodyGroup bodies) {
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    if (!bodies.empty()) violations.push_back({rule, idsOf(bodies, question.product)});
  };
  const BodyGroup demanded = heldBy(group, present, question.rules, false);
  BodyGroup nuts;
  for (const std::size_t body : heldBy(group, present, question.rules, true)) {
    if (std::find(demanded.begin(), demanded.end(), body) == demanded.end()) nuts.push_back(body);
  }
  add(StepViolation::Rule::Before, demanded);
  add(StepViolation::Rule::Fastener, nuts);
  add(StepViolation::Rule::Joint, heldByJoints(group, present, question, true));
  add(StepViolation::Rule::Standing, falling);
  if (question.rules.placeOf(group) != number) violations.push_back({StepViolation::Rule::Place, {}});
  return violations;
}

void addAllowances(StepMotion& motion, const BodyGroup& group, const std::vector<Fit>& fits,
                   const AssembledProduct& product) {
  // If both bodies are thinned, pitch and turns are stated once.
  std::set<std::pair<std::size_t, std::size_t>> threads;
  for (Fit fit : fits) {
    const RigidBody& body = product.bodies[fit.object];
    const RigidBody& other = product.bodies[fit.obstacle];
    if (fit.thread && !threads.emplace(fit.object, fit.obstacle).second) {
      fit.thread.reset();
      fit.pitch = 0.0;
    }
    Allowance& allowance = fit;
    if (fit.object == group.front()) allowance.moving = {};
    if (fit.thread) allowance.turns = turnsIn(fit.thread->rule, body, other, motion.path);
    allowance.text = withTurns(inWords(fit, body.shown(), other.shown()), allowance.turns);
    motion.allowances.push_back(std::move(allowance));
  }
}

StepMotion makeMotion(const BodyGroup& group, const Removed& removed, const SequenceQuestion& question,
                      const BodySet& present, std::size_t afterSteps) {
  const AssembledProduct& product = question.product;
  const MotionCertificate& certificate = removed.path.certificate;
  StepMotion motion;
  motion.body = product.bodies[group.front()].id;
  motion.path = removed.path.points;
  motion.method = removed.method;
  motion.with = idsOf({group.begin() + 1, group.end()}, product);
  if (group.size() == 1 && !question.fasteners.empty()) motion.fastener = question.fasteners[group.front()];
  if (group.size() == 1 && needsTool(group.front(), present, question)) {
    motion.tool.kind = question.tools[group.front()].front().kind;
  }
  motion.proof = {afterSteps, certificate.tolerance, certificate.provedClearance, certificate.minClearance, {}};
  const int nearest = certificate.nearest.body;
  if (nearest >= 0) motion.proof.nearest = product.bodies[static_cast<std::size_t>(nearest)].id;
  addAllowances(motion, group, removed.fits, product);
  return motion;
}

StepMotion makeFlexibleMotion(std::size_t body, const BodySet& present, const SequenceQuestion& question,
                              std::size_t afterSteps) {
  const RigidBody& own = question.product.bodies[body];
  const Vector3 direction = flexibleDirection(body, question);
  const double margin = leavingMargin(radiusAboutOrigin(*own.mesh));
  Pose end = own.X_WB;
  end.position +=
      wayOutOf(boundingBox(*own.mesh, own.X_WB), boxOf(question.product, without(present, {body})), direction, margin) *
      direction;
  StepMotion motion;
  motion.body = own.id;
  motion.path = {{own.X_WB}, {end}};
  motion.method = kFlexible;
  if (!question.tools.empty() && !question.tools[body].empty()) motion.tool.kind = question.tools[body].front().kind;
  motion.proof.afterSteps = afterSteps;
  motion.certified = false;
  return motion;
}

}  // namespace glissade
