#include "engine/sequence/order_rules.h"

#include <algorithm>
#include <set>

namespace glissade {
namespace {

bool isNamed(const std::string& id, const std::string& name) {
  if (id == name) return true;
  const std::string end = "/" + name;
  return id.size() > end.size() && id.compare(id.size() - end.size(), end.size(), end) == 0;
}

Diagnostic refusedDemand(const std::string& reason, const std::string& advice) {
  return {ErrorKind::Usage, "", "", reason, advice};
}

Diagnostic unknownBody(const std::string& name) {
  return refusedDemand("a demand names '" + name + "', which is no body of the product",
                       "See 'glissade-cli fits' for the names.");
}

/// Bodies that only leave together are one node. Takes away what nothing has to precede, until nothing is left.
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

}  // namespace

BodyGroup bodiesNamed(const AssembledProduct& product, const std::string& name) {
  BodyGroup bodies;
  for (std::size_t body = 0; body < product.bodies.size(); ++body) {
    if (isNamed(product.bodies[body].id, name)) bodies.push_back(body);
  }
  return bodies;
}

Result<BodySet> stayingBodies(const AssembledProduct& product, const std::vector<std::string>& names) {
  BodySet staying(product.bodies.size(), false);
  if (names.empty()) staying[largestBody(product)] = true;
  for (const std::string& name : names) {
    const BodyGroup bodies = bodiesNamed(product, name);
    for (const std::size_t body : bodies) staying[body] = true;
    if (bodies.empty()) {
      return Diagnostic{ErrorKind::Usage, "", "stay", "names '" + name + "', which is no body of the product",
                        "See 'glissade-cli fits' for the names."};
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
          return refusedDemand("'" + product.bodies[body].id + "' is demanded to leave with others twice",
                               "Name each body once.");
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
  if (isCircular(rules, product.bodies.size())) {
    return refusedDemand("the demands about the order go in a circle", "Remove one of them.");
  }
  return rules;
}

}  // namespace glissade
