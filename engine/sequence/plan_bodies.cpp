#include "engine/sequence/plan_bodies.h"

#include <map>
#include <set>

namespace glissade {
namespace {

/// The id in the product of each body of the plan; empty where one has none, or two have the same.
std::map<std::string, std::string> idsInProduct(const AssembledProduct& product, const AssemblyPlan& plan) {
  std::map<std::string, std::string> byName;
  for (const RigidBody& body : product.bodies) byName.emplace(body.name, body.id);
  for (const RigidBody& body : product.bodies) byName[body.id] = body.id;
  std::map<std::string, std::string> ids;
  std::set<std::string> used;
  for (const std::string& body : plan.bodies) {
    const auto found = byName.find(body);
    if (found == byName.end() || !used.insert(found->second).second) return {};
    ids.emplace(body, found->second);
  }
  return ids;
}

}  // namespace

std::vector<std::size_t> bodiesOf(const AssemblyStep& step, const AssembledProduct& product) {
  std::vector<std::size_t> bodies;
  for (const std::string& id : step.bodies()) bodies.push_back(*product.indexOf(id));
  return bodies;
}

std::optional<AssemblyPlan> planAbout(const AssembledProduct& product, const AssemblyPlan& plan) {
  if (plan.bodies.size() != product.bodies.size()) return std::nullopt;
  const auto ids = idsInProduct(product, plan);
  if (ids.size() != plan.bodies.size()) return std::nullopt;
  const auto rename = [&ids](std::string& id) {
    if (!id.empty()) id = ids.at(id);
  };
  const auto renameAll = [&rename](std::vector<std::string>& list) {
    for (std::string& id : list) rename(id);
  };
  AssemblyPlan renamed = plan;
  for (std::size_t i = 0; i < renamed.bodies.size(); ++i) renamed.bodies[i] = product.bodies[i].id;
  renameAll(renamed.staying);
  for (AssemblyStep& step : renamed.steps) {
    rename(step.body);
    renameAll(step.with);
    rename(step.proof.nearest);
    for (StepAllowance& allowance : step.allowances) {
      rename(allowance.body);
      rename(allowance.moving);
    }
  }
  for (RefusedRemoval& refused : renamed.refusals) {
    rename(refused.body);
    renameAll(refused.with);
    renameAll(refused.blockedBy);
  }
  for (StuckBody& stuck : renamed.stuck) {
    rename(stuck.body);
    renameAll(stuck.blockedBy);
  }
  return renamed;
}

}  // namespace glissade
