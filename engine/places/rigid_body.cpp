#include "engine/places/rigid_body.h"

#include "engine/model/product.h"

namespace glissade {

void labelBodies(std::vector<RigidBody>& bodies, const Product& product) {
  std::vector<std::string> ids;
  for (const RigidBody& body : bodies) ids.push_back(body.id);
  const std::vector<std::string> shown = product.labels(ids);
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].label = shown[i];
}

}  // namespace glissade
