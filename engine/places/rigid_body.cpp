#include "engine/places/rigid_body.h"

#include "engine/model/product.h"

namespace glissade {

std::vector<BodyId> idsOf(const std::vector<RigidBody>& bodies) {
  std::vector<BodyId> ids;
  for (const RigidBody& body : bodies) ids.push_back(body.id);
  return ids;
}

void labelBodies(std::vector<RigidBody>& bodies, const Product& product) {
  const std::vector<std::string> shown = product.labels(textsOf(idsOf(bodies)));
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].label = shown[i];
}

}  // namespace glissade
