#include "engine/planning/automatic/eroded_worlds.h"

namespace glissade {

CollisionWorldPtr ErodedWorlds::at(double depth) {
  if (depth == 0.0) return world_;
  const std::lock_guard lock(mutex_);
  CollisionWorldPtr& world = built_[depth];
  if (!world) {
    world = world_->withObjects([&](const TriangleMesh& object) {
      const auto known = objects_.try_emplace(&object, object).first;
      return std::make_shared<const TriangleMesh>(known->second.eroded(depth));
    });
  }
  return world;
}

void ErodedWorlds::keepOnly(double depth) {
  const std::lock_guard lock(mutex_);
  for (auto world = built_.begin(); world != built_.end();) {
    world = world->first == depth ? std::next(world) : built_.erase(world);
  }
}

}  // namespace glissade
