#pragma once

#include <memory>
#include <vector>

#include "engine/collision/collision_query.h"
#include "engine/collision/fcl_query.h"
#include "engine/collision/kernel/occurrence_query.h"
#include "engine/collision/solids.h"

namespace glissade {

/// Prepared obstacles and object of a world, for one backend. One of the last three members is set, or none where the
/// world consists of groups.
struct WorldGeometry {
  CollisionBackend backend = CollisionBackend::Kernel;
  std::shared_ptr<const std::vector<RigidBody>> obstacles;
  Box3 obstaclesBox;
  MeshPtr object;
  std::shared_ptr<const Solids> solids;
  std::shared_ptr<const KernelGeometry> kernel;           ///< all obstacles in one tree
  std::shared_ptr<const OccurrenceGeometry> occurrences;  ///< one tree for each mesh
  std::shared_ptr<const FclGeometry> fcl;
};

/// True if the obstacles have so many triangles that each mesh has its own tree. Small worlds have one tree for all,
/// because its order of triangles decides between equally near pairs.
bool isLarge(const std::vector<RigidBody>& obstacles);

/// True for the same mesh, by pointer, and the same pose.
bool isSamePlaced(const RigidBody& a, const RigidBody& b);

/// Prepares each mesh once; data of `known` for the same meshes are reused. Answers do not depend on `known`, which may
/// be null. `large`: one tree for each mesh.
WorldGeometry prepareGeometry(std::vector<RigidBody> obstacles, const MeshPtr& object, CollisionBackend backend,
                              bool large, const WorldGeometry* known);

/// Another object among the same obstacles, which are not prepared again.
WorldGeometry withOtherObject(const WorldGeometry& geometry, const MeshPtr& object);

}  // namespace glissade
