#pragma once

#include <map>
#include <mutex>

#include "engine/collision/collision_query.h"
#include "engine/collision/kernel/kernel_query.h"
#include "engine/collision/solids.h"

namespace glissade {

/// A mesh, as the kernel wants an obstacle; all bodies with this mesh share it. Immutable.
struct PreparedObstacle {
  std::shared_ptr<const BoxTree> tree;
  Solids::SolidPtr solid;
};

/// A mesh, as the kernel wants the object. Immutable.
struct PreparedObject {
  MeshPtr mesh;
  double radius = 0.0;
  std::shared_ptr<const MotionBound> motionBound;
  std::shared_ptr<const BoxTree> tree;
  Solids::SolidPtr solid;
};

/// An obstacle of a world, and the object as it is taken against it.
struct ComposedObstacle {
  RigidBody body;
  Box3 box_W;
  std::shared_ptr<const PreparedObstacle> obstacle;
  std::shared_ptr<const PreparedObject> object;
};

/// Bodies of a product, for worlds of any choice of them: each mesh is prepared once, when it is first needed, as an
/// obstacle, and once as an object. A world then costs microseconds a body. Worlds keep what they need. May be asked
/// by several threads at a time.
class PreparedBodies {
 public:
  explicit PreparedBodies(std::vector<RigidBody> bodies);

  /// An obstacle of a world, by its index, and the mesh that the object is taken to be against it.
  struct Against {
    std::size_t body;
    MeshPtr object;
    MeshPtr obstacle = nullptr;  ///< the mesh that the obstacle is taken to be, in its frame; null: its own
  };
  /// The world's obstacles are numbered as they are listed here. The meshes are in one frame, inside `object`.
  CollisionWorldPtr world(const MeshPtr& object, const std::vector<Against>& obstacles);

  /// A mesh that no later world needs: what was prepared of it lives as long as the worlds that have it.
  void forget(const MeshPtr& mesh);

  const std::vector<RigidBody>& bodies() const { return bodies_; }
  const Box3& boxOf(std::size_t body) const { return boxes_[body]; }

 private:
  using ObstaclePtr = std::shared_ptr<const PreparedObstacle>;
  using ObjectPtr = std::shared_ptr<const PreparedObject>;
  ObstaclePtr obstacle(const MeshPtr& mesh);
  ObjectPtr object(const MeshPtr& mesh);

  std::vector<RigidBody> bodies_;
  std::vector<Box3> boxes_;
  double scale_;
  std::mutex mutex_;  ///< of what follows
  std::map<MeshPtr, ObstaclePtr> obstacles_;
  std::map<MeshPtr, ObjectPtr> objects_;
};

}  // namespace glissade
