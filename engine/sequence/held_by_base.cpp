#include "engine/sequence/held_by_base.h"

#include <algorithm>

#include "engine/sequence/joint_rules.h"

namespace glissade {
namespace {

/// The fixed bodies; if there are none, the largest one of those that stay.
std::vector<std::size_t> rootsOf(const AssembledProduct& product, const BodySet& staying, const BodySet& fixed) {
  std::vector<std::size_t> roots = bodiesIn(fixed);
  const std::vector<std::size_t> all = bodiesIn(staying);
  if (!roots.empty() || all.empty()) return roots;
  return {*std::max_element(all.begin(), all.end(), [&](std::size_t a, std::size_t b) {
    return boxVolume(product.bodies[a]) < boxVolume(product.bodies[b]);
  })};
}

}  // namespace

std::vector<HeldByBase> heldByBase(const AssembledProduct& product, const Joints& joints, const BodySet& staying,
                                   const BodySet& fixed) {
  std::vector<std::size_t> reached = rootsOf(product, staying, fixed);
  BodySet open = without(staying, reached);
  std::vector<HeldByBase> held;
  const auto reach = [&](std::size_t body, std::size_t with, JointKind kind) {
    if (!open[body]) return;
    open[body] = false;
    reached.push_back(body);
    held.push_back({product.bodies[body].id, kind, product.bodies[with].id});
  };
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const std::size_t from = reached[i];
    for (const Joint& joint : joints) {
      if (!isBonded(joint)) continue;
      const bool isOther = std::find(joint.others.begin(), joint.others.end(), from) != joint.others.end();
      if (isOther) reach(joint.body, from, joint.kind);
      if (!isOther && joint.body != from) continue;
      for (const std::size_t other : joint.others) reach(other, from, joint.kind);
    }
  }
  return held;
}

}  // namespace glissade
