#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/base/parameters.h"
#include "engine/collision/motion_certificate.h"
#include "engine/collision/prepared_bodies.h"
#include "engine/planning/path.h"
#include "engine/sequence/direction_rule.h"
#include "engine/sequence/product_fits.h"

namespace glissade {

/// A group of bodies as one rigid body that moves. A single body keeps its frame; several bodies have a frame at the
/// middle of their common bounding box, with the world's orientation.
struct MovingObject {
  MeshPtr mesh;
  Pose X_WB;              ///< pose where the product is assembled
  double radius = 0.0;    ///< radius about the frame's origin, metres
  double required = 0.0;  ///< clearance that its motions keep, metres: the least of those of its bodies
};

/// The collision world of a group while other bodies are there.
struct MotionWorld {
  CollisionWorldPtr world;
  std::vector<std::size_t> bodies;  ///< index in the product of each obstacle of the world
};

/// The collision worlds in which groups of a product's bodies move. Bodies and groups are prepared once. Thread-safe.
class MotionWorlds {
 public:
  /// Unit directions in which each body may not move (DirectionRule); empty: none.
  using Forbidden = std::vector<std::vector<Vector3>>;

  /// Refers to product and fits.
  MotionWorlds(const AssembledProduct& product, const ProductFits& fits, Forbidden forbidden = {});

  const MovingObject& object(const BodyGroup& group);
  /// Each body of the group is thinned by its allowances, leaves threads by turning only, and keeps out of directions
  /// that a person forbids. Bodies of the group are no obstacles.
  MotionWorld world(const BodyGroup& group, const BodySet& present);
  /// False if a person forbids the body to move in this direction: no motion may begin so.
  bool mayBegin(const Vector3& direction, std::size_t body) const;
  /// The world of one body beside one other body. Forbidden directions are not considered.
  CollisionWorldPtr pair(std::size_t body, std::size_t other);
  /// The world of an object that is no body of the product, beside one body, which is not thinned.
  CollisionWorldPtr beside(const MeshPtr& thing, std::size_t other) { return prepared_.world(thing, {{other, thing}}); }
  /// Default parameters for the group's size, with one slot.
  ParameterValues parameters(const BodyGroup& group);
  const Box3& boxOf(std::size_t body) const { return prepared_.boxOf(body); }
  /// A box that contains all points nearer to the group than its required clearance, anywhere on the path.
  Box3 sweptBy(const BodyGroup& group, const std::vector<PathPoint>& path);

 private:
  /// Bodies of a group that move past the same obstacle: its mesh is equal for all, and all or none are screwed to it.
  struct Part {
    std::size_t other;
    MeshPtr obstacle;
    bool screwed;
    BodyGroup bodies;
  };
  MotionWorld withoutDirections(const BodyGroup& group, const BodySet& present);
  std::vector<DirectedBody> directedBodies(const BodyGroup& group, const BodySet& present);
  std::vector<std::size_t> touchedBy(std::size_t body);
  bool touch(std::size_t body, std::size_t other, double distance);
  std::vector<Part> partsAgainst(const BodyGroup& group, std::size_t other) const;
  std::vector<ThreadPair> threadsOf(const BodyGroup& group, const std::vector<Part>& parts);
  MeshPtr meshOf(const BodyGroup& group, const BodyGroup& bodies, const std::vector<MeshPtr>& meshes);
  MeshPtr meshAgainst(const BodyGroup& group, const Part& part);
  MeshPtr wholeOf(const BodyGroup& group, const BodyGroup& bodies);
  MeshPtr joined(const BodyGroup& bodies, const std::vector<MeshPtr>& meshes, const Pose& X_WG) const;

  const AssembledProduct& product_;
  const ProductFits& fits_;
  Forbidden forbidden_;
  PreparedBodies& prepared_;
  std::mutex mutex_;  ///< protects the members below
  std::map<BodyGroup, MovingObject> objects_;
  std::map<std::size_t, std::vector<std::size_t>> touched_;  ///< contacts of bodies with forbidden directions
  /// Joined meshes of bodies of a group as they are taken against an obstacle, by the mesh of the whole group.
  std::map<MeshPtr, std::map<std::pair<BodyGroup, std::vector<MeshPtr>>, MeshPtr>> joined_;
};

/// Replaces indices of obstacles in the motion world by indices of bodies in the product.
void nameByProduct(MotionCertificate& certificate, const std::vector<std::size_t>& bodies);

}  // namespace glissade
