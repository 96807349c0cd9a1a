#include "engine/planning/automatic/eroded_worlds.h"

namespace glissade {

CollisionWorldPtr ErodedWorlds::at(double depth) {
  if (depth == 0.0) return world_;
  const std::lock_guard lock(mutex_);
  CollisionWorldPtr& world = built_[depth];
  if (!world) {
    if (!object_) object_.emplace(world_->object());
    world = world_->withObject(std::make_shared<const TriangleMesh>(object_->eroded(depth)));
  }
  return world;
}

}  // namespace glissade
