#pragma once

#include <map>
#include <mutex>

#include "engine/collision/collision_query.h"
#include "engine/collision/kernel/kernel_query.h"
#include "engine/collision/solids.h"

namespace glissade {

/// A mesh prepared as an obstacle for the kernel; all bodies with this mesh share it. Immutable.
struct PreparedObstacle {
  std::shared_ptr<const BoxTree> tree;
  Solids::SolidPtr solid;
};

/// A mesh prepared as the object for the kernel. Immutable.
struct PreparedObject {
  MeshPtr mesh;
  double radius = 0.0;
  std::shared_ptr<const MotionBound> motionBound;
  std::shared_ptr<const BoxTree> tree;
  Solids::SolidPtr solid;
};

/// An obstacle of a world, and the replacement of the object against it.
struct ComposedObstacle {
  RigidBody body;
  Box3 box_W;
  std::shared_ptr<const PreparedObstacle> obstacle;
  std::shared_ptr<const PreparedObject> object;
};

/// Prepared bodies of a product, from which worlds are composed. Each mesh is prepared at most once as an obstacle and
/// once as an object, when it is first needed. A world then takes microseconds per body. Worlds keep the data that they
/// need. Thread-safe.
class PreparedBodies {
 public:
  explicit PreparedBodies(std::vector<RigidBody> bodies, BoxCare care = BoxCare::ForManyQueries);

  /// An obstacle of a world, by its index, and the mesh that replaces the object against it.
  struct Against {
    std::size_t body;
    MeshPtr object;
    MeshPtr obstacle = nullptr;  ///< mesh that replaces the obstacle, in its frame; null: its own
  };
  /// The world of an object and obstacles, in the order of `obstacles`. The replacing meshes are in the frame of
  /// `object`, inside it.
  CollisionWorldPtr world(const MeshPtr& object, const std::vector<Against>& obstacles);

  /// Forgets a mesh that no later world needs. Its prepared data live as long as the worlds that use them.
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
  BoxCare care_;
  std::mutex mutex_;  ///< guards the members below
  std::map<MeshPtr, ObstaclePtr> obstacles_;
  std::map<MeshPtr, ObjectPtr> objects_;
};

}  // namespace glissade
