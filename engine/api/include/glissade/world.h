#pragma once

#include <glissade/export.h>
#include <glissade/mesh.h>
#include <glissade/stop_token.h>

#include <memory>
#include <string>
#include <vector>

namespace glissade::api {

/// A rigid body that is placed in the world.
struct Body {
  std::string id{};    ///< unique in its world or product
  std::string name{};  ///< for people; empty: the id
  Mesh mesh;           ///< in the body's frame B
  Pose X_WB{};         ///< pose in the world
};

/// The nearest pair of points of the object and an obstacle.
struct Nearest {
  double distance = 0.0;           ///< metres; 0 if they touch or penetrate; infinite without obstacles
  std::string body{};              ///< id of the obstacle; empty: none
  Vector3 p_WO = Vector3::Zero();  ///< point of the obstacle, world frame; undefined for a distance of 0
  Vector3 p_WN = Vector3::Zero();  ///< point of the object, world frame; undefined for a distance of 0
};

/// The result of the proof of a motion.
enum class ProofStatus {
  Certified,  ///< the clearance is proved on the whole motion
  Violated,   ///< a configuration with less clearance was found
  Undecided   ///< stopped before either was shown
};

/// The proof about a motion, which covers every configuration on it.
struct Certificate {
  ProofStatus status = ProofStatus::Undecided;  ///< what is proved
  double required = 0.0;                        ///< required clearance, metres
  double provedClearance = 0.0;                 ///< lower bound on the clearance over the whole motion, metres
  double minClearance = 0.0;                    ///< smallest clearance that was met, metres
  std::size_t edge = 0;                         ///< edge with the smallest clearance, or the edge that is violated
  double at = 0.0;                              ///< place on that edge, in [0, 1]
  Nearest nearest{};                            ///< nearest points at that place

  /// True if the motion is proved.
  bool certified() const { return status == ProofStatus::Certified; }
};

class World;

/// Questions about one world. Copies ask the same query. A query with its copies belongs to one thread.
class GLISSADE_EXPORT Query {
 public:
  /// True if the object at this pose touches or penetrates an obstacle. Error (Usage): an invalid pose.
  Result<bool> collides(const Pose& X_WB);
  /// The nearest obstacle, with an exact distance. Error (Usage): an invalid pose.
  Result<Nearest> nearest(const Pose& X_WB);
  /// Proves or refutes that the straight motion keeps the required clearance: linear in position, shortest in
  /// orientation. Errors (Usage): an invalid pose, a clearance that is not above 0.
  Result<Certificate> certify(const Pose& from, const Pose& to, double required, const StopToken& stop = {});
  /// The share of the straight motion that is free of collisions, by samples at a distance of `step` metres. It is no
  /// proof. Errors (Usage): an invalid pose, a step that is not above 0, a start in collision.
  Result<double> freeShare(const Pose& from, const Pose& to, double step, const StopToken& stop = {});

  /// Private data.
  struct Impl;
  /// For the library.
  explicit Query(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}
  Query(const Query&) = default;             ///< asks the same query
  Query& operator=(const Query&) = default;  ///< asks the same query
  /// For the library.
  const Impl& impl() const { return *impl_; }

 private:
  std::shared_ptr<Impl> impl_;
};

/// Placed obstacles and the mesh of the object that moves among them. Immutable; copies share everything; any thread
/// may read it.
class GLISSADE_EXPORT World {
 public:
  /// Errors (Usage): an empty or repeated id, an invalid pose.
  static Result<World> make(const std::vector<Body>& obstacles, const Mesh& object);

  /// The obstacles.
  std::vector<Body> obstacles() const;
  /// The mesh of the object, in its frame B.
  Mesh object() const;
  /// Largest distance of a point of the object from its frame's origin, metres. Rotations count by it: the distance of
  /// two configurations is sqrt(|dp|^2 + (radius * angle)^2).
  double objectRadius() const;
  /// Queries for one thread. The first one of a large world prepares it, which takes seconds.
  Query query() const;

  /// Private data.
  struct Impl;
  /// For the library.
  explicit World(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
  World(const World&) = default;             ///< shares everything
  World& operator=(const World&) = default;  ///< shares everything
  /// For the library.
  const Impl& impl() const { return *impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
};

}  // namespace glissade::api
