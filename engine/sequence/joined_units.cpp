#include "engine/sequence/joined_units.h"

#include <algorithm>

namespace glissade {
namespace {

bool haveCommon(const BodyGroup& a, const BodyGroup& b) {
  return std::any_of(a.begin(), a.end(),
                     [&](std::size_t body) { return std::binary_search(b.begin(), b.end(), body); });
}

BodyGroup united(const BodyGroup& a, const BodyGroup& b) {
  BodyGroup both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

/// Frame of a group of several bodies, see MovingObject.
Pose frameOf(const BodyGroup& group, const AssembledProduct& product) {
  Box3 box;
  for (const std::size_t body : group) {
    box.extend(boundingBox(*product.bodies[body].mesh, product.bodies[body].X_WB));
  }
  return Pose::translation(box.center());
}

const BodyGroup& grown(const BodyGroup& group, const std::vector<BodyGroup>& groups) {
  const auto larger =
      std::find_if(groups.begin(), groups.end(), [&](const auto& each) { return haveCommon(each, group); });
  return larger == groups.end() ? group : *larger;
}

}  // namespace

BodySet withJoined(BodySet set, const std::vector<BodyGroup>& bonded) {
  for (const BodyGroup& group : bonded) {
    if (std::none_of(group.begin(), group.end(), [&](std::size_t body) { return set[body]; })) continue;
    for (const std::size_t body : group) set[body] = true;
  }
  return set;
}

void joinUnits(const std::vector<BodyGroup>& bonded, const AssembledProduct& product, OrderRules& rules) {
  for (BodyGroup group : bonded) {
    for (auto at = rules.together.begin(); at != rules.together.end();) {
      const bool isPart = haveCommon(*at, group);
      if (isPart) group = united(*at, group);
      at = isPart ? rules.together.erase(at) : std::next(at);
    }
    rules.together.push_back(std::move(group));
  }
  for (auto& step : rules.placed) step.group = grown(step.group, rules.together);
  for (auto& motion : rules.motions) {
    const BodyGroup& group = grown(motion.group, rules.together);
    if (group == motion.group) continue;
    const Pose X_PG = inverse(motion.path.front().q) * frameOf(group, product);
    for (PathPoint& point : motion.path) point.q = point.q * X_PG;
    motion.group = group;
  }
}

}  // namespace glissade
