#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/environment/rigid_body.h"

namespace glissade {

/// Nearest pair between the object and all obstacles (paper 1, Find_Nearest_Obstacle).
struct NearestObstacle {
  double distance = 0.0;  ///< metres, >= 0; exactly 0 where the object touches, penetrates, or is contained
  int body = -1;  ///< index into CollisionWorld::obstacles(); -1 where there is no obstacle (distance is +infinity)
  Vector3 p_WPo = Vector3::Zero();  ///< P_o on the obstacle; meaningless where distance is 0
  Vector3 p_WPn = Vector3::Zero();  ///< P_n on the object; meaningless where distance is 0

  /// Unit contact normal from the obstacle to the object; zero where distance is 0.
  Vector3 normal_W() const {
    const Vector3 gap = p_WPn - p_WPo;
    const double length = gap.norm();
    return distance > 0.0 && length > 0.0 ? Vector3(gap / length) : Vector3(Vector3::Zero());
  }
};

struct QueryCounts {
  std::uint64_t collision = 0;
  std::uint64_t distance = 0;
};

/// Asks one CollisionWorld. One query object per thread; poses must be valid (isValid).
/// Solids are solids: the object wholly inside a closed obstacle, or around one, is in collision.
class CollisionQuery {
 public:
  virtual ~CollisionQuery() = default;

  /// The object at X_WB touches or penetrates an obstacle.
  virtual bool collides(const Pose& X_WB) = 0;
  /// Index of one obstacle that is in collision, the lowest; nothing where free.
  virtual std::optional<int> collidingBody(const Pose& X_WB) = 0;
  /// Exact distance (error below 1e-9 relative, never over-estimated beyond that).
  virtual NearestObstacle nearestObstacle(const Pose& X_WB) = 0;

  virtual const QueryCounts& counts() const = 0;
};

/// The geometry that a planner plans in: obstacles in place and the object's mesh. Immutable, shared
/// by all threads.
class CollisionWorld {
 public:
  /// Meshes must be finite, indices in range (importers guarantee it). The object may not be empty.
  static std::shared_ptr<const CollisionWorld> build(std::vector<RigidBody> obstacles, MeshPtr object);
  ~CollisionWorld();
  CollisionWorld(const CollisionWorld&) = delete;
  CollisionWorld& operator=(const CollisionWorld&) = delete;

  const std::vector<RigidBody>& obstacles() const;
  const TriangleMesh& object() const;
  /// Largest distance of a point of the object from its reference point.
  double objectRadius() const;
  /// Bounding box of all obstacles; empty where there is none.
  const Box3& obstaclesBox() const;

  /// A query for one thread.
  std::unique_ptr<CollisionQuery> makeQuery() const;

  /// Private data of the implementation.
  struct Impl;

 private:
  explicit CollisionWorld(std::unique_ptr<const Impl> impl);
  std::unique_ptr<const Impl> impl_;
};

using CollisionWorldPtr = std::shared_ptr<const CollisionWorld>;

}  // namespace glissade
