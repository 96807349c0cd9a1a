#include "engine/sequence/order_rules.h"

#include <algorithm>
#include <array>
#include <set>

#include "engine/model/body_choice.h"
#include "engine/sequence/step_motion.h"

namespace glissade {
namespace {

Diagnostic refusedDemand(const Message& reason, const Message& advice) {
  return {ErrorKind::Usage, "", "", reason, advice};
}

Diagnostic unknownBody(const std::string& name) {
  return refusedDemand({GLISSADE_TEXT("a constraint names '%1', which is not a body of the product"), {name}},
                       GLISSADE_TEXT("See 'glissade-cli fits' for the names."));
}

/// Finds circles by removing nodes that nothing has to precede until none is left. Bodies that leave together are one
/// node.
bool isCircular(const OrderRules& rules, std::size_t bodies) {
  std::vector<std::size_t> node(bodies);
  for (std::size_t body = 0; body < bodies; ++body) node[body] = body;
  for (const BodyGroup& group : rules.together) {
    for (const std::size_t body : group) node[body] = group.front();
  }
  std::set<std::pair<std::size_t, std::size_t>> open;
  for (const OrderRule& rule : rules.before) open.insert({node[rule.first], node[rule.then]});
  for (bool changed = true; changed;) {
    changed = false;
    for (auto at = open.begin(); at != open.end();) {
      const std::size_t first = at->first;
      const bool free =
          std::none_of(open.begin(), open.end(), [&](const auto& other) { return other.second == first; });
      at = free ? open.erase(at) : std::next(at);
      changed = changed || free;
    }
  }
  return !open.empty();
}

/// The bodies of a step that a person names, ascending.
Result<BodyGroup> stepNamed(const std::vector<std::string>& names, const AssembledProduct& product) {
  std::set<std::size_t> bodies;
  for (const std::string& name : names) {
    const BodyGroup named = bodiesNamed(product, name);
    if (named.empty()) return unknownBody(name);
    bodies.insert(named.begin(), named.end());
  }
  if (bodies.empty()) {
    return refusedDemand(GLISSADE_TEXT("a constraint about a step names no body"),
                         GLISSADE_TEXT("Name the bodies that are removed."));
  }
  return BodyGroup(bodies.begin(), bodies.end());
}

/// Adds the rule that the bodies of a step leave as one.
Outcome leaveTogether(const BodyGroup& group, const AssembledProduct& product, OrderRules& rules) {
  for (const BodyGroup& other : rules.together) {
    if (other == group) return Done{};
    for (const std::size_t body : group) {
      if (!std::binary_search(other.begin(), other.end(), body)) continue;
      return refusedDemand(
          {GLISSADE_TEXT("'%1' is in two constrained steps or groups"), {product.bodies[body].id.text()}},
          GLISSADE_TEXT("Name the same bodies in both, or remove one."));
    }
  }
  if (group.size() > 1) rules.together.push_back(group);
  return Done{};
}

Outcome addPlaces(const SequenceDemands& demands, const AssembledProduct& product, OrderRules& rules) {
  std::set<std::size_t> taken;
  std::set<std::size_t> placed;
  for (const DemandedPlace& demand : demands.places) {
    auto group = stepNamed(demand.bodies, product);
    if (!group) return group.error();
    const Outcome together = leaveTogether(*group, product, rules);
    if (!together) return together;
    if (demand.place == 0 || !taken.insert(demand.place).second) {
      return refusedDemand({GLISSADE_TEXT("two steps are constrained to place %1"), {demand.place}},
                           GLISSADE_TEXT("Give each a place of its own, from 1."));
    }
    for (const std::size_t body : *group) {
      if (placed.insert(body).second) continue;
      return refusedDemand({GLISSADE_TEXT("'%1' is constrained to two places"), {product.bodies[body].id.text()}},
                           GLISSADE_TEXT("Remove one of them."));
    }
    rules.placed.push_back({std::move(*group), demand.place});
  }
  std::sort(rules.placed.begin(), rules.placed.end(), [](const auto& a, const auto& b) { return a.place < b.place; });
  return Done{};
}

Outcome addMotions(const SequenceDemands& demands, const AssembledProduct& product, OrderRules& rules) {
  for (const DemandedMotion& demand : demands.motions) {
    auto group = stepNamed(demand.bodies, product);
    if (!group) return group.error();
    const Outcome together = leaveTogether(*group, product, rules);
    if (!together) return together;
    if (demand.path.size() < 2) {
      return refusedDemand(GLISSADE_TEXT("a motion of a constraint has fewer than two configurations"),
                           GLISSADE_TEXT("Give two configurations."));
    }
    if (rules.motionOf(*group) != nullptr) {
      return refusedDemand(
          {GLISSADE_TEXT("'%1' is constrained to two motions"), {product.bodies[group->front()].id.text()}},
          GLISSADE_TEXT("Remove one."));
    }
    rules.motions.push_back({std::move(*group), demand.path, demand.method});
  }
  return Done{};
}

Outcome addForbidden(const SequenceDemands& demands, const AssembledProduct& product, OrderRules& rules) {
  if (!demands.forbidden.empty()) rules.forbidden.resize(product.bodies.size());
  for (const ForbiddenDirection& demand : demands.forbidden) {
    const BodyGroup bodies = bodiesNamed(product, demand.body);
    if (bodies.empty()) return unknownBody(demand.body);
    if (!(demand.direction.norm() > 0.0)) {
      return refusedDemand({GLISSADE_TEXT("a direction that is ruled out for '%1' has no length"), {demand.body}},
                           GLISSADE_TEXT("Give three numbers, as 0 0 -1."));
    }
    for (const std::size_t body : bodies) rules.forbidden[body].push_back(demand.direction.normalized());
  }
  return Done{};
}

/// A demanded motion may not be forbidden as well.
Outcome checkMotions(const OrderRules& rules, const AssembledProduct& product) {
  for (const OrderRules::GivenMotion& motion : rules.motions) {
    if (!isForbidden(firstDirection(motion.path), rules.forbiddenTo(motion.group))) continue;
    return refusedDemand({GLISSADE_TEXT("'%1' is constrained to a motion in a direction that is ruled out for it"),
                          {product.bodies[motion.group.front()].id.text()}},
                         GLISSADE_TEXT("Remove one of the two constraints."));
  }
  return Done{};
}

}  // namespace

const OrderRules::GivenMotion* OrderRules::motionOf(const BodyGroup& group) const {
  const auto found =
      std::find_if(motions.begin(), motions.end(), [&](const auto& each) { return each.group == group; });
  return found == motions.end() ? nullptr : &*found;
}

std::vector<Vector3> OrderRules::forbiddenTo(const BodyGroup& group) const {
  std::vector<Vector3> all;
  if (forbidden.empty()) return all;
  for (const std::size_t body : group) all.insert(all.end(), forbidden[body].begin(), forbidden[body].end());
  return all;
}

std::size_t OrderRules::placeOf(const BodyGroup& group) const {
  const auto found = std::find_if(placed.begin(), placed.end(), [&](const auto& each) { return each.group == group; });
  return found == placed.end() ? 0 : found->place;
}

BodyGroup bodiesNamed(const AssembledProduct& product, const std::string& name) {
  return bodiesMeant(idsOf(product.bodies), name, product.tree);
}

Result<BodySet> stayingBodies(const AssembledProduct& product, const std::vector<std::string>& names) {
  BodySet staying(product.bodies.size(), false);
  for (const std::string& name : names) {
    const BodyGroup bodies = bodiesNamed(product, name);
    for (const std::size_t body : bodies) staying[body] = true;
    if (bodies.empty()) {
      return Diagnostic{ErrorKind::Usage,
                        "",
                        "stay",
                        {GLISSADE_TEXT("names '%1', which is not a body of the product"), {name}},
                        GLISSADE_TEXT("See 'glissade-cli fits' for the names.")};
    }
  }
  return staying;
}

Result<OrderRules> resolved(const SequenceDemands& demands, const AssembledProduct& product) {
  OrderRules rules;
  std::set<std::size_t> grouped;
  for (const auto& names : demands.together) {
    BodyGroup group;
    for (const std::string& name : names) {
      const BodyGroup bodies = bodiesNamed(product, name);
      if (bodies.empty()) return unknownBody(name);
      for (const std::size_t body : bodies) {
        if (!grouped.insert(body).second) {
          return refusedDemand({GLISSADE_TEXT("'%1' is in two groups that are to be removed together"),
                                {product.bodies[body].id.text()}},
                               GLISSADE_TEXT("Name each body once."));
        }
        group.push_back(body);
      }
    }
    std::sort(group.begin(), group.end());
    if (group.size() > 1) rules.together.push_back(std::move(group));
  }
  for (const auto& [first, then] : demands.before) {
    const BodyGroup firsts = bodiesNamed(product, first);
    const BodyGroup thens = bodiesNamed(product, then);
    if (firsts.empty()) return unknownBody(first);
    if (thens.empty()) return unknownBody(then);
    for (const std::size_t one : firsts) {
      for (const std::size_t other : thens) rules.before.push_back({one, other, true});
    }
  }
  for (const auto add : {addPlaces, addMotions, addForbidden}) {
    const Outcome added = add(demands, product, rules);
    if (!added) return added.error();
  }
  if (const Outcome possible = checkMotions(rules, product); !possible) return possible.error();
  if (isCircular(rules, product.bodies.size())) {
    return refusedDemand(GLISSADE_TEXT("the constraints on the order form a cycle"),
                         GLISSADE_TEXT("Remove one of them."));
  }
  return rules;
}

}  // namespace glissade
