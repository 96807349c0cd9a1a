#include "engine/product/joint_order.h"

#include <algorithm>
#include <numeric>

namespace glissade {
namespace {

/// Maps bonded bodies to one representative.
class JoinedBodies {
 public:
  JoinedBodies(const Joints& joints, std::size_t bodies) : parent_(bodies) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (const Joint& joint : joints) {
      const bool isOne =
          joint.kind == JointKind::Insert || joint.kind == JointKind::Permanent || joint.kind == JointKind::Unit;
      if (!isOne || joint.state == JointState::Suggested) continue;
      for (const std::size_t other : joint.others) parent_[rootOf(other)] = rootOf(joint.body);
    }
  }

  std::size_t rootOf(std::size_t body) const {
    while (parent_[body] != body) body = parent_[body];
    return body;
  }

 private:
  std::vector<std::size_t> parent_;
};

/// For each body, the bodies that leave after it.
std::vector<std::vector<std::size_t>> laterBodies(const Joints& joints, const JoinedBodies& joined,
                                                  std::size_t bodies) {
  std::vector<std::vector<std::size_t>> later(bodies);
  for (const Joint& joint : joints) {
    if (joint.state == JointState::Suggested) continue;
    std::vector<std::size_t> after = joint.clamped;
    const bool isBeforeOthers = joint.kind == JointKind::Nut || joint.kind == JointKind::Flexible;
    if (isBeforeOthers) after.insert(after.end(), joint.others.begin(), joint.others.end());
    const std::size_t first = joined.rootOf(joint.body);
    for (const std::size_t body : after) {
      if (joined.rootOf(body) != first) later[first].push_back(joined.rootOf(body));
    }
  }
  return later;
}

}  // namespace

std::vector<std::size_t> circleThrough(std::size_t body, const Joints& joints, std::size_t bodies) {
  const JoinedBodies joined(joints, bodies);
  const auto later = laterBodies(joints, joined, bodies);
  const std::size_t start = joined.rootOf(body);
  constexpr auto kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> from(bodies, kNone);
  std::vector<std::size_t> open{start};
  for (std::size_t i = 0; i < open.size(); ++i) {
    for (const std::size_t next : later[open[i]]) {
      if (next == start) {
        std::vector<std::size_t> circle;
        for (std::size_t at = open[i]; at != start; at = from[at]) circle.push_back(at);
        circle.push_back(start);
        std::reverse(circle.begin(), circle.end());
        return circle;
      }
      if (from[next] != kNone) continue;
      from[next] = open[i];
      open.push_back(next);
    }
  }
  return {};
}

}  // namespace glissade
