#include "engine/sequence/plan_steps.h"

#include <algorithm>

namespace glissade {

std::vector<std::string> idsOf(const BodyGroup& bodies, const AssembledProduct& product) {
  std::vector<std::string> ids;
  for (const std::size_t body : bodies) ids.push_back(product.bodies[body].id);
  return ids;
}

BodyGroup groupOf(const AssemblyStep& step, const AssembledProduct& product) {
  BodyGroup group;
  for (const std::string& id : step.bodies()) group.push_back(*product.indexOf(id));
  std::sort(group.begin(), group.end());
  return group;
}

AssemblyStep makeStep(const BodyGroup& group, const Removed& removed, const SequenceQuestion& question,
                      std::size_t afterSteps) {
  const AssembledProduct& product = question.product;
  const MotionCertificate& certificate = removed.path.certificate;
  AssemblyStep step;
  step.body = product.bodies[group.front()].id;
  step.path = removed.path.points;
  step.method = removed.method;
  step.with = idsOf({group.begin() + 1, group.end()}, product);
  if (group.size() == 1 && !question.fasteners.empty()) step.fastener = question.fasteners[group.front()];
  step.proof = {afterSteps, certificate.tolerance, certificate.provedClearance, certificate.minClearance, {}};
  const int nearest = certificate.nearest.body;
  if (nearest >= 0) step.proof.nearest = product.bodies[static_cast<std::size_t>(nearest)].id;
  for (const BodyFit& each : removed.fits) {
    const RigidBody& body = product.bodies[each.body];
    const RigidBody& other = product.bodies[each.fit.obstacle];
    const std::string text =
        each.yields ? inWords(each.fit, other.name, body.name) : inWords(each.fit, body.name, other.name);
    step.allowances.push_back({other.id, each.fit.kind, each.fit.overlap, each.fit.allowance, text,
                               each.body == group.front() ? std::string() : body.id, each.yields});
  }
  return step;
}

}  // namespace glissade
