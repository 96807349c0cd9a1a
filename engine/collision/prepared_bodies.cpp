#include "engine/collision/prepared_bodies.h"

namespace glissade {

PreparedBodies::PreparedBodies(std::vector<RigidBody> bodies)
    : bodies_(std::move(bodies)), scale_(kernelScale(bodies_)) {
  for (const RigidBody& body : bodies_) boxes_.push_back(boundingBox(*body.mesh, body.X_WB));
}

CollisionWorldPtr PreparedBodies::world(const MeshPtr& whole, const std::vector<Against>& obstacles) {
  std::vector<std::pair<const PreparedObstacle*, const PreparedObject*>> prepared;
  for (const Against& against : obstacles) {
    const MeshPtr& mesh = against.obstacle ? against.obstacle : bodies_[against.body].mesh;
    prepared.emplace_back(&obstacle(against.body, mesh), &object(against.object));
  }
  return CollisionWorld::compose(object(whole), prepared);
}

/// Two threads that need the same one may both prepare it; the first is kept.
const PreparedObstacle& PreparedBodies::obstacle(std::size_t body, const MeshPtr& mesh) {
  {
    const std::lock_guard lock(mutex_);
    const auto known = obstacles_.find({body, mesh});
    if (known != obstacles_.end()) return known->second;
  }
  RigidBody own = bodies_[body];
  own.mesh = mesh;
  PreparedObstacle prepared{own, boxes_[body], scale_, kernelObstacle(own, scale_),
                            Solids::prepare(transformed(*own.mesh, own.X_WB))};
  const std::lock_guard lock(mutex_);
  return obstacles_.try_emplace(std::pair(body, mesh), std::move(prepared)).first->second;
}

const PreparedObject& PreparedBodies::object(const MeshPtr& mesh) {
  {
    const std::lock_guard lock(mutex_);
    const auto known = objects_.find(mesh);
    if (known != objects_.end()) return known->second;
  }
  PreparedObject prepared{mesh, radiusAboutOrigin(*mesh), std::make_shared<const MotionBound>(*mesh),
                          kernelObject(*mesh, scale_), Solids::prepare(*mesh)};
  const std::lock_guard lock(mutex_);
  return objects_.try_emplace(mesh, std::move(prepared)).first->second;
}

}  // namespace glissade
