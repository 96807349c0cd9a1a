#include "engine/environment/rigid_body.h"

namespace glissade {

void labelBodies(std::vector<RigidBody>& bodies) {
  std::vector<std::string> ids;
  std::vector<std::string> names;
  for (const RigidBody& body : bodies) {
    ids.push_back(body.id);
    names.push_back(body.name);
  }
  const std::vector<std::string> shown = shownNames(ids, names);
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].label = shown[i];
}

}  // namespace glissade
