#include "engine/fits/fitted_world.h"

#include <algorithm>

namespace glissade {
namespace {

/// `screwed`: also thins the bodies of fits that are threads.
CollisionWorldPtr thinnedBy(const std::vector<Fit>& fits, const CollisionWorldPtr& world, const MeshPtr& object,
                            bool screwed) {
  std::vector<ObjectVariant> variants;
  std::vector<RigidBody> obstacles = world->obstacles();
  bool yields = false;
  for (const Fit& fit : fits) {
    if (!fit.thinned || (fit.thread && !screwed)) continue;
    if (fit.yields) {
      obstacles[fit.obstacle].mesh = fit.thinned;
      yields = true;
    } else {
      ObjectVariant variant;
      variant.object = fit.thinned;
      variant.obstacles.push_back(static_cast<int>(fit.obstacle));
      variants.push_back(std::move(variant));
    }
  }
  const CollisionWorldPtr thinned = yields ? world->updated(std::move(obstacles), object) : world;
  return thinned->withVariants(std::move(variants));
}

}  // namespace

CollisionWorldPtr withFits(const CollisionWorldPtr& world, const MeshPtr& object, const std::vector<Fit>& fits) {
  CollisionWorldPtr screwed = thinnedBy(fits, world, object, true);
  const std::vector<ThreadRule> rules = threadRulesOf(fits);
  if (rules.empty()) return screwed;
  std::vector<ThreadPair> pairs;
  for (const ThreadRule& rule : rules) {
    pairs.emplace_back(rule, *object, world->obstacles()[static_cast<std::size_t>(rule.obstacle)]);
  }
  return screwed->withThreads(std::move(pairs), thinnedBy(fits, world, object, false));
}

std::vector<ThreadRule> threadRulesOf(const std::vector<Fit>& fits) {
  std::vector<ThreadRule> rules;
  for (const Fit& fit : fits) {
    const bool known = std::any_of(rules.begin(), rules.end(), [&](const ThreadRule& rule) {
      return rule.obstacle == static_cast<int>(fit.obstacle);
    });
    if (!fit.thread || known) continue;
    rules.push_back(fit.thread->rule);
    rules.back().obstacle = static_cast<int>(fit.obstacle);
  }
  return rules;
}

}  // namespace glissade
