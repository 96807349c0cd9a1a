#include "engine/environment/rigid_body.h"

namespace glissade {

void labelBodies(std::vector<RigidBody>& bodies, RigidBody* more) {
  std::vector<RigidBody*> all;
  for (RigidBody& body : bodies) all.push_back(&body);
  if (more != nullptr) all.push_back(more);
  std::vector<std::string> ids;
  std::vector<std::string> names;
  for (const RigidBody* body : all) {
    ids.push_back(body->id);
    names.push_back(body->name);
  }
  const std::vector<std::string> shown = shownNames(ids, names);
  for (std::size_t i = 0; i < all.size(); ++i) all[i]->label = shown[i];
}

}  // namespace glissade
