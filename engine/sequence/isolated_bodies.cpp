#include "engine/sequence/isolated_bodies.h"

#include <algorithm>

namespace glissade {
namespace {

constexpr double kApart = 0.01;

}  // namespace

BodyGroup isolatedBodies(const AssembledProduct& product, const LiaisonGraph& graph) {
  if (graph.liaisons().empty()) return {};
  std::vector<Box3> boxes;
  Box3 whole;
  for (const RigidBody& body : product.bodies) {
    boxes.push_back(boundingBox(*body.mesh, body.X_WB));
    whole.extend(boxes.back());
  }
  const double apart = kApart * whole.diagonal().norm();
  BodyGroup isolated;
  for (std::size_t body = 0; body < boxes.size(); ++body) {
    if (!graph.neighboursOf(body).empty()) continue;
    const bool isBeside = std::any_of(boxes.begin(), boxes.end(), [&](const Box3& other) {
      return &other != &boxes[body] && boxes[body].exteriorDistance(other) <= apart;
    });
    if (!isBeside) isolated.push_back(body);
  }
  return isolated;
}

}  // namespace glissade
