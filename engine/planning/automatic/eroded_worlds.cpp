#include "engine/planning/automatic/eroded_worlds.h"

#include "engine/planning/automatic/eroded_mesh.h"

namespace glissade {

CollisionWorldPtr ErodedWorlds::at(double depth) {
  if (depth == 0.0) return world_;
  CollisionWorldPtr& world = built_[depth];
  if (!world) {
    auto mesh = std::make_shared<const TriangleMesh>(eroded(world_->object(), depth));
    world = CollisionWorld::build(world_->obstacles(), std::move(mesh));
  }
  return world;
}

}  // namespace glissade
