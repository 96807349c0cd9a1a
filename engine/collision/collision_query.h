#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/base/stop_token.h"
#include "engine/collision/forbidden_regions.h"
#include "engine/collision/motion_bound.h"
#include "engine/environment/rigid_body.h"

namespace glissade {

/// Stands for an obstacle's index where a person forbids the place that the reference point is in or at, or the motion.
inline constexpr int kForbiddenPlace = -2;

/// Nearest pair between the object and all obstacles (paper 1, Find_Nearest_Obstacle).
struct NearestObstacle {
  double distance = 0.0;  ///< metres, >= 0; exactly 0 where the object touches, penetrates, or is contained
  /// Index into CollisionWorld::obstacles(); -1 where there is no obstacle (distance is +infinity), kForbiddenPlace in
  /// a forbidden place (distance is 0).
  int body = -1;
  Vector3 p_WPo = Vector3::Zero();  ///< P_o on the obstacle; meaningless where distance is 0
  Vector3 p_WPn = Vector3::Zero();  ///< P_n on the object; meaningless where distance is 0

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
  Undecided   ///< stopped, or out of steps, before either was shown
};

/// Which violation of a motion is of interest.
enum class SeekViolation {
  Any,   ///< yes or no: the cheapest
  First  ///< to within a thousandth of the object's size, and all before it proved
};

/// Yes or no about a whole motion, without the distances on the way (those are in MotionCertificate).
struct MotionCheck {
  CertificateStatus status = CertificateStatus::Undecided;
  double certified = 0.0;            ///< the requirement is proved on [0, certified]
  double at = 1.0;                   ///< where a violation was found, if Violated
  std::uint64_t configurations = 0;  ///< looked at
};

struct ScrewAxis;  ///< geometry/screw_axis.h

struct QueryCounts {
  std::uint64_t collision = 0;
  std::uint64_t distance = 0;  ///< exact ones, and up to a bound
  std::uint64_t motion = 0;
  /// Pairs of boxes and of leaves that our kernel has looked at for all of these: what they cost, by the same measure
  /// on every machine. FCL and screws do not count.
  std::uint64_t pairs = 0;

  QueryCounts& operator+=(const QueryCounts& more) {
    collision += more.collision;
    distance += more.distance;
    motion += more.motion;
    pairs += more.pairs;
    return *this;
  }
};

/// Who answers for surfaces: our own kernel, or FCL as its reference and fallback.
enum class CollisionBackend { Kernel, Fcl };

/// Asks one CollisionWorld. One query object per thread; poses must be valid (isValid).
/// Solids are solids: the object wholly inside a closed obstacle, or around one, is in collision.
class CollisionQuery {
 public:
  virtual ~CollisionQuery() = default;

  /// The object at X_WB touches or penetrates an obstacle.
  virtual bool collides(const Pose& X_WB) = 0;
  /// Index of one obstacle that is in collision, the lowest; else kForbiddenPlace in a forbidden place; nothing where
  /// free.
  virtual std::optional<int> collidingBody(const Pose& X_WB) = 0;
  /// Exact distance (error below 1e-9 relative, never over-estimated beyond that).
  virtual NearestObstacle nearestObstacle(const Pose& X_WB) = 0;
  /// min(distance, enough), as exact as nearestObstacle and cheaper the smaller `enough` is.
  virtual double distanceUpTo(const Pose& X_WB, double enough) = 0;
  /// The distance is larger than `bound` (>= 0): ends at the first pair that is not.
  virtual bool clearAbove(const Pose& X_WB, double bound) = 0;
  /// Whether the straight motion keeps the required clearance (> 0): proved, or where it is violated.
  virtual MotionCheck checkMotion(const Pose& from, const Pose& to, double required, SeekViolation seek,
                                  const StopToken& stop) = 0;

  /// Lower bound on the distance while the object moves from there by the screw motion, by any part of the advance
  /// (metres, any number of turns); never above `enough`. 0: nothing is shown. It takes seconds among many triangles.
  /// `off`: metres that points of the object may be off this motion, for threads with a rule; the distance is that of
  /// the motion itself.
  virtual double screwClearance(const Pose& from, const ScrewAxis& screw, double advance, double enough,
                                double off) = 0;

  /// Where the straight motion first leads through a forbidden place; nothing where it keeps out of all.
  virtual std::optional<ForbiddenStretch> forbiddenOn(const Pose& /*from*/, const Pose& /*to*/) { return std::nullopt; }

  /// False where a person forbids the straight motion, in this direction.
  virtual bool mayMove(const Pose& /*from*/, const Pose& /*to*/) { return true; }
  /// Metres that the reference point keeps from forbidden places at least; 0: there are none.
  virtual double forbiddenMargin() { return 0.0; }

  /// Of the object of this query's world.
  virtual const MotionBound& motionBound() const = 0;
  virtual QueryCounts counts() const = 0;
};

/// What the object is taken to be against some of the obstacles: a mesh inside its own, in the same frame.
struct ObjectVariant {
  MeshPtr object;
  std::vector<int> obstacles;  ///< indices; no obstacle is in two variants
};

struct ComposedObstacle;
struct PreparedObject;
struct ThreadedWorld;
class ThreadPair;

/// The geometry that a planner plans in: obstacles in place and the object's mesh. Immutable, shared
/// by all threads.
class CollisionWorld : public std::enable_shared_from_this<CollisionWorld> {
 public:
  /// Meshes must be finite, indices in range (importers guarantee it). The object may not be empty. Large worlds are
  /// prepared when the first query is made.
  static std::shared_ptr<const CollisionWorld> build(std::vector<RigidBody> obstacles, MeshPtr object,
                                                     CollisionBackend backend = CollisionBackend::Kernel);
  /// A world of bodies that were prepared before, for this scale of the kernel. Nothing is prepared again. The kernel
  /// answers.
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
  /// The same world, asked of another backend.
  std::shared_ptr<const CollisionWorld> withBackend(CollisionBackend backend) const;

  /// Another object among the same obstacles, which are not prepared again. Precondition: there are no variants.
  std::shared_ptr<const CollisionWorld> withObject(MeshPtr object) const;
  /// The object and each of its variants are replaced by what `change` makes of their meshes. The obstacles are not
  /// prepared again.
  std::shared_ptr<const CollisionWorld> withObjects(const std::function<MeshPtr(const TriangleMesh&)>& change) const;

  /// The same world where the object has variants. Each obstacle is prepared once, with the variant that is its own.
  /// Those that there were are replaced; a world without variants answers as one that never had any.
  std::shared_ptr<const CollisionWorld> withVariants(std::vector<ObjectVariant> variants) const;
  const std::vector<ObjectVariant>& variants() const;

  /// The same world with threads between the object and obstacles, each of which comes apart by turning only. `whole`:
  /// the same world, where these pairs are taken whole, as they are once a thread is disengaged.
  /// All other worlds that are made of this one have no threads, but withObjects() and withBackend().
  std::shared_ptr<const CollisionWorld> withThreads(std::vector<ThreadPair> pairs,
                                                    std::shared_ptr<const CollisionWorld> whole) const;
  /// The same world where the object's reference point keeps out of what is forbidden at the time of each question
  /// (ForbiddingQuery). Null: nothing is forbidden. All worlds that are made of this one keep it.
  std::shared_ptr<const CollisionWorld> withForbidden(std::shared_ptr<const ForbiddenSpace> space) const;
  /// Null where nothing is.
  ForbiddenRegionsPtr forbidden() const;

  /// Those that the object's thread is in.
  const std::vector<ThreadPair>& threads() const;

  /// Other obstacles, or another object. Bodies with the same mesh (by pointer) at the same pose are not prepared
  /// again, where that leaves every answer as build() would give it.
  std::shared_ptr<const CollisionWorld> updated(std::vector<RigidBody> obstacles, MeshPtr object) const;

  /// A query can be made at once. Of a large world it takes seconds until all is prepared; makeQuery() does that, and
  /// so do the functions that make another world of this one.
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
