#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/base/enum_names.h"
#include "engine/base/stop_token.h"
#include "engine/collision/forbidden_regions.h"
#include "engine/collision/motion_bound.h"
#include "engine/places/rigid_body.h"

namespace glissade {

/// Replaces an obstacle's index where a person forbids the place of the reference point, or the motion.
inline constexpr int kForbiddenPlace = -2;

/// Nearest pair between the object and all obstacles (paper 1, Find_Nearest_Obstacle).
struct NearestObstacle {
  double distance = 0.0;  ///< metres, >= 0; exactly 0 where the object touches, penetrates, or is contained
  /// Index into CollisionWorld::obstacles(); -1 where there is no obstacle (distance is +infinity), kForbiddenPlace in
  /// a forbidden place (distance is 0).
  int body = -1;
  Vector3 p_WPo = Vector3::Zero();  ///< P_o on the obstacle; undefined where distance is 0
  Vector3 p_WPn = Vector3::Zero();  ///< P_n on the object; undefined where distance is 0

  /// Unit contact normal from the obstacle to the object; zero where distance is 0.
  Vector3 normal_W() const {
    const Vector3 gap = p_WPn - p_WPo;
    const double length = gap.norm();
    return distance > 0.0 && length > 0.0 ? Vector3(gap / length) : Vector3(Vector3::Zero());
  }
};

enum class CertificateStatus {
  Certified,  ///< proved: clearance stays at or above the requirement on the whole motion
  Violated,   ///< a configuration with less clearance than required was found
  Undecided   ///< ended by a stop or by the limit of steps before either was shown
};

/// The violation of a motion that is searched for.
enum class SeekViolation {
  Any,   ///< any violation: the cheapest
  First  ///< the first violation, to within a thousandth of the object's size; the motion before it is proved
};

/// Result of a check of a whole motion, without the distances on it (those are in MotionCertificate).
struct MotionCheck {
  CertificateStatus status = CertificateStatus::Undecided;
  double certified = 0.0;            ///< the requirement is proved on [0, certified]
  double at = 1.0;                   ///< place of the violation, if Violated
  std::uint64_t configurations = 0;  ///< number of configurations evaluated
};

struct ScrewAxis;  ///< see geometry/screw_axis.h

struct QueryCounts {
  std::uint64_t collision = 0;
  std::uint64_t distance = 0;  ///< exact distances, and distances up to a bound
  std::uint64_t motion = 0;
  /// Pairs of boxes and of leaves that our kernel has tested for all of these queries: a measure of their cost that is
  /// the same on every machine. FCL and screws do not count.
  std::uint64_t pairs = 0;

  QueryCounts& operator+=(const QueryCounts& more) {
    collision += more.collision;
    distance += more.distance;
    motion += more.motion;
    pairs += more.pairs;
    return *this;
  }
};

/// Implementation of the surface queries: our own kernel, or FCL as its reference and fallback.
enum class CollisionBackend { Kernel, Fcl };
inline constexpr EnumNames<CollisionBackend, 2> kCollisionBackendNames{{"kernel", "fcl"}};

/// Queries of one CollisionWorld. One query object per thread; poses must be valid (isValid). Obstacles are solids: an
/// object wholly inside a closed obstacle, or around one, is in collision.
class CollisionQuery {
 public:
  virtual ~CollisionQuery() = default;

  /// True if the object at X_WB touches or penetrates an obstacle.
  virtual bool collides(const Pose& X_WB) = 0;
  /// Lowest index of an obstacle in collision; else kForbiddenPlace in a forbidden place; nothing where free.
  virtual std::optional<int> collidingBody(const Pose& X_WB) = 0;
  /// Exact distance (error below 1e-9 relative, never over-estimated beyond that).
  virtual NearestObstacle nearestObstacle(const Pose& X_WB) = 0;
  /// min(distance, enough), as exact as nearestObstacle and cheaper the smaller `enough` is.
  virtual double distanceUpTo(const Pose& X_WB, double enough) = 0;
  /// True if the distance is larger than `bound` (>= 0). Ends at the first pair that is not.
  virtual bool clearAbove(const Pose& X_WB, double bound) = 0;
  /// Checks whether the straight motion keeps the required clearance (> 0): a proof, or the place of a violation.
  virtual MotionCheck checkMotion(const Pose& from, const Pose& to, double required, SeekViolation seek,
                                  const StopToken& stop) = 0;

  /// Lower bound on the distance while the object makes the screw motion from `from`, by any part of the advance
  /// (metres, any number of turns); never above `enough`. 0: nothing is proved. It takes seconds among many triangles.
  /// `off`: largest distance of points of the object from this motion, metres, for threads with a rule; the bound is
  /// that of the motion itself.
  virtual double screwClearance(const Pose& from, const ScrewAxis& screw, double advance, double enough,
                                double off) = 0;

  /// The first part of the straight motion in a forbidden place; nothing where it avoids all.
  virtual std::optional<ForbiddenStretch> forbiddenOn(const Pose& /*from*/, const Pose& /*to*/) { return std::nullopt; }

  /// False where a person forbids the straight motion, in this direction.
  virtual bool mayMove(const Pose& /*from*/, const Pose& /*to*/) { return true; }
  /// Least distance that the reference point keeps from forbidden places, metres; 0: there are none.
  virtual double forbiddenMargin() { return 0.0; }

  /// Motion bound of the object of this query's world.
  virtual const MotionBound& motionBound() const = 0;
  virtual QueryCounts counts() const = 0;
};

/// A replacement of the object against some of the obstacles: a mesh inside the object's mesh, in the same frame.
struct ObjectVariant {
  MeshPtr object;
  std::vector<int> obstacles;  ///< indices of obstacles; no obstacle is in two variants
};

struct ComposedObstacle;
struct PreparedObject;
struct ThreadedWorld;
class ThreadPair;

/// The geometry for planning: placed obstacles and the object's mesh. Immutable, shared by all threads.
class CollisionWorld : public std::enable_shared_from_this<CollisionWorld> {
 public:
  /// Meshes must be finite, indices in range (importers guarantee it). The object may not be empty. Large worlds are
  /// prepared when the first query is made.
  static std::shared_ptr<const CollisionWorld> build(std::vector<RigidBody> obstacles, MeshPtr object,
                                                     CollisionBackend backend = CollisionBackend::Kernel);
  /// A world of prepared bodies with this scale of the kernel. Nothing is prepared again. Queries use the kernel.
  static std::shared_ptr<const CollisionWorld> compose(double scale, const PreparedObject& object,
                                                       std::vector<ComposedObstacle> obstacles);
  ~CollisionWorld();
  CollisionWorld(const CollisionWorld&) = delete;
  CollisionWorld& operator=(const CollisionWorld&) = delete;

  const std::vector<RigidBody>& obstacles() const;
  const TriangleMesh& object() const;
  /// Largest distance of a point of the object from its reference point.
  double objectRadius() const;
  /// Bounding box of all obstacles; empty where there is none.
  const Box3& obstaclesBox() const;

  CollisionBackend backend() const;
  /// This world with another backend.
  std::shared_ptr<const CollisionWorld> withBackend(CollisionBackend backend) const;

  /// Another object among the same obstacles, which are not prepared again. Precondition: there are no variants.
  std::shared_ptr<const CollisionWorld> withObject(MeshPtr object) const;
  /// This world with the object and each of its variants replaced by the result of `change` for their meshes. The
  /// obstacles are not prepared again.
  std::shared_ptr<const CollisionWorld> withObjects(const std::function<MeshPtr(const TriangleMesh&)>& change) const;

  /// This world with variants of the object, which replace existing ones. Each obstacle is prepared once, with its
  /// variant. A world without variants gives the same answers as one that never had any.
  std::shared_ptr<const CollisionWorld> withVariants(std::vector<ObjectVariant> variants) const;
  const std::vector<ObjectVariant>& variants() const;

  /// This world with threads between the object and obstacles, which come apart only by turning. `whole`: the same
  /// world in which these pairs are whole, as after a thread is disengaged. All other worlds made from this one have no
  /// threads, except those of withObjects() and withBackend().
  std::shared_ptr<const CollisionWorld> withThreads(std::vector<ThreadPair> pairs,
                                                    std::shared_ptr<const CollisionWorld> whole) const;
  /// This world in which the object's reference point keeps out of the places that are forbidden at the time of
  /// each query (ForbiddingQuery). Null: nothing is forbidden. All worlds made from this one keep it.
  std::shared_ptr<const CollisionWorld> withForbidden(std::shared_ptr<const ForbiddenSpace> space) const;
  /// The forbidden regions; null where nothing is forbidden.
  ForbiddenRegionsPtr forbidden() const;

  /// The threads that the object has in this world.
  const std::vector<ThreadPair>& threads() const;

  /// A world with other obstacles or another object. Bodies with the same mesh (by pointer) at the same pose are not
  /// prepared again, where that gives the same answers as build().
  std::shared_ptr<const CollisionWorld> updated(std::vector<RigidBody> obstacles, MeshPtr object) const;

  /// True if a query can be made at once. Preparing a large world takes seconds; makeQuery() does it, and so do the
  /// functions that make another world of this one.
  bool isPrepared() const;
  /// A query for one thread.
  std::unique_ptr<CollisionQuery> makeQuery() const;

  /// Private data of the implementation.
  struct Impl;

 private:
  explicit CollisionWorld(std::unique_ptr<const Impl> impl);
  static std::shared_ptr<const CollisionWorld> buildLater(std::vector<RigidBody> obstacles, const MeshPtr& object,
                                                          CollisionBackend backend);
  static std::shared_ptr<const CollisionWorld> finished(std::unique_ptr<Impl> impl, MeshPtr object);
  std::shared_ptr<const CollisionWorld> withThreaded(std::shared_ptr<const ThreadedWorld> threads) const;
  std::shared_ptr<const CollisionWorld> withoutThreads() const;

  std::unique_ptr<const Impl> impl_;
};

using CollisionWorldPtr = std::shared_ptr<const CollisionWorld>;

}  // namespace glissade
