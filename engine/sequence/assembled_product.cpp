#include "engine/sequence/assembled_product.h"

#include <algorithm>
#include <map>

namespace glissade {

std::optional<std::size_t> AssembledProduct::indexOf(const std::string& id) const {
  const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const RigidBody& body) { return body.id == id; });
  if (found == bodies.end()) return std::nullopt;
  return static_cast<std::size_t>(found - bodies.begin());
}

std::vector<ContactBody> contactBodiesOf(const AssembledProduct& product) {
  std::vector<ContactBody> bodies;
  for (std::size_t i = 0; i < product.bodies.size(); ++i) {
    const RigidBody& body = product.bodies[i];
    bodies.push_back({body.id, body.mesh, body.X_WB, product.deflections[i]});
  }
  return bodies;
}

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

std::vector<RigidBody> aboutTheirMiddles(std::vector<RigidBody> bodies) {
  struct Middle {
    Vector3 point;
    MeshPtr mesh;
  };
  std::map<MeshPtr, Middle> known;
  for (RigidBody& body : bodies) {
    Middle& middle = known[body.mesh];
    if (!middle.mesh) {
      middle.point = boundingBox(*body.mesh).center();
      middle.mesh = std::make_shared<const TriangleMesh>(transformed(*body.mesh, Pose::translation(-middle.point)));
    }
    body.X_WB.position = body.X_WB * middle.point;
    body.mesh = middle.mesh;
  }
  return bodies;
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
