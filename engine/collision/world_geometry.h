#pragma once

#include <memory>
#include <vector>

#include "engine/collision/collision_query.h"
#include "engine/collision/fcl_query.h"
#include "engine/collision/kernel/occurrence_query.h"
#include "engine/collision/solids.h"

namespace glissade {

/// What is prepared of the obstacles and the object of a world, for one backend. One of the last three is there, or
/// none where the world consists of groups.
struct WorldGeometry {
  CollisionBackend backend = CollisionBackend::Kernel;
  std::shared_ptr<const std::vector<RigidBody>> obstacles;
  Box3 obstaclesBox;
  MeshPtr object;
  std::shared_ptr<const Solids> solids;
  std::shared_ptr<const KernelGeometry> kernel;           ///< all obstacles in one tree
  std::shared_ptr<const OccurrenceGeometry> occurrences;  ///< a tree for each mesh
  std::shared_ptr<const FclGeometry> fcl;
};

/// The obstacles have so many triangles that they are a tree for each mesh, and not one tree for all. Small worlds keep
/// the one tree, because its order of triangles decides between equally near pairs.
bool isLarge(const std::vector<RigidBody>& obstacles);

/// Same mesh, by pointer, and same pose.
bool isSamePlaced(const RigidBody& a, const RigidBody& b);

/// Prepares each mesh once; what `known` has prepared of the same meshes is not prepared again. Answers are those of a
/// geometry that is made without `known`, which may be null. `large`: a tree for each mesh.
WorldGeometry prepareGeometry(std::vector<RigidBody> obstacles, const MeshPtr& object, CollisionBackend backend,
                              bool large, const WorldGeometry* known);

/// Another object among the same obstacles, which are not prepared again.
WorldGeometry withOtherObject(const WorldGeometry& geometry, const MeshPtr& object);

}  // namespace glissade
