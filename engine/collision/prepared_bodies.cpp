#include "engine/collision/prepared_bodies.h"

namespace glissade {

PreparedBodies::PreparedBodies(std::vector<RigidBody> bodies, BoxCare care) : bodies_(std::move(bodies)), care_(care) {
  Box3 all;
  for (const RigidBody& body : bodies_) {
    boxes_.push_back(boundingBox(*body.mesh, body.X_WB));
    all.extend(boxes_.back());
  }
  scale_ = kernelScale(all);
}

CollisionWorldPtr PreparedBodies::world(const MeshPtr& whole, const std::vector<Against>& obstacles) {
  std::vector<ComposedObstacle> composed;
  composed.reserve(obstacles.size());
  for (const Against& against : obstacles) {
    RigidBody body = bodies_[against.body];
    if (against.obstacle) body.mesh = against.obstacle;
    ObstaclePtr prepared = obstacle(body.mesh);
    composed.push_back({std::move(body), boxes_[against.body], std::move(prepared), object(against.object)});
  }
  return CollisionWorld::compose(scale_, *object(whole), std::move(composed));
}

void PreparedBodies::forget(const MeshPtr& mesh) {
  const std::lock_guard lock(mutex_);
  obstacles_.erase(mesh);
  objects_.erase(mesh);
}

/// The prepared obstacle of a mesh. Two threads that need the same one may both prepare it; the first is kept.
PreparedBodies::ObstaclePtr PreparedBodies::obstacle(const MeshPtr& mesh) {
  {
    const std::lock_guard lock(mutex_);
    const auto known = obstacles_.find(mesh);
    if (known != obstacles_.end()) return known->second;
  }
  auto prepared = std::make_shared<const PreparedObstacle>(
      PreparedObstacle{kernelObstacle(*mesh, scale_, care_), Solids::prepare(*mesh)});
  const std::lock_guard lock(mutex_);
  return obstacles_.try_emplace(mesh, std::move(prepared)).first->second;
}

PreparedBodies::ObjectPtr PreparedBodies::object(const MeshPtr& mesh) {
  {
    const std::lock_guard lock(mutex_);
    const auto known = objects_.find(mesh);
    if (known != objects_.end()) return known->second;
  }
  auto prepared = std::make_shared<const PreparedObject>(
      PreparedObject{mesh, radiusAboutOrigin(*mesh), std::make_shared<const MotionBound>(*mesh),
                     kernelObject(*mesh, scale_, care_), Solids::prepare(*mesh)});
  const std::lock_guard lock(mutex_);
  return objects_.try_emplace(mesh, std::move(prepared)).first->second;
}

}  // namespace glissade
