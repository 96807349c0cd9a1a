#include "engine/sequence/body_group.h"

#include <algorithm>

namespace glissade {

std::vector<std::size_t> bodiesIn(const BodySet& set) {
  std::vector<std::size_t> indices;
  for (std::size_t body = 0; body < set.size(); ++body) {
    if (set[body]) indices.push_back(body);
  }
  return indices;
}

BodySet without(BodySet set, const BodyGroup& group) {
  for (const std::size_t body : group) set[body] = false;
  return set;
}

Box3 boxOf(const AssembledProduct& product, const BodySet& set) {
  Box3 box;
  for (const std::size_t body : bodiesIn(set)) {
    box.extend(boundingBox(*product.bodies[body].mesh, product.bodies[body].X_WB));
  }
  return box;
}

double boxVolume(const RigidBody& body) { return boundingBox(*body.mesh).sizes().prod(); }

double boxVolume(const AssembledProduct& product, const BodyGroup& group) {
  double volume = 0.0;
  for (const std::size_t body : group) volume += boxVolume(product.bodies[body]);
  return volume;
}

std::size_t largestBody(const AssembledProduct& product) {
  const auto smaller = [](const RigidBody& a, const RigidBody& b) { return boxVolume(a) < boxVolume(b); };
  const auto largest = std::max_element(product.bodies.begin(), product.bodies.end(), smaller);
  return static_cast<std::size_t>(largest - product.bodies.begin());
}

}  // namespace glissade
