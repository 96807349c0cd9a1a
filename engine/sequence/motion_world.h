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

/// A group of bodies as the one rigid body that moves. A single body is itself, in its frame; several are in a frame
/// at the middle of their common bounding box, with the world's orientation.
struct MovingObject {
  MeshPtr mesh;
  Pose X_WB;              ///< where the product is assembled
  double radius = 0.0;    ///< about the frame's origin, metres
  double required = 0.0;  ///< clearance that its motions keep, metres: the least of those of its bodies
};

/// What a group moves in while others are there.
struct MotionWorld {
  CollisionWorldPtr world;
  std::vector<std::size_t> bodies;  ///< index in the product of each obstacle of the world
};

/// The worlds in which groups of a product's bodies move. Bodies are prepared once, groups once. May be asked by
/// several threads at a time.
class MotionWorlds {
 public:
  /// Directions in which bodies may not move (DirectionRule), unit, of each body; empty: none.
  using Forbidden = std::vector<std::vector<Vector3>>;

  /// Refers to product and fits.
  MotionWorlds(const AssembledProduct& product, const ProductFits& fits, Forbidden forbidden = {});

  const MovingObject& object(const BodyGroup& group);
  /// Each body of the group is thinned as its fits allow, leaves threads by turning only, and keeps out of directions
  /// that a person forbids; bodies of the group are no obstacles.
  MotionWorld world(const BodyGroup& group, const BodySet& present);
  /// False where a person forbids this direction to the body: no motion begins so.
  bool mayBegin(const Vector3& direction, std::size_t body) const;
  /// Of one body beside one other. Directions are not looked at.
  CollisionWorldPtr pair(std::size_t body, std::size_t other);
  /// Of something that is no body of the product, beside one body. The body is whole.
  CollisionWorldPtr beside(const MeshPtr& thing, std::size_t other) { return prepared_.world(thing, {{other, thing}}); }
  /// The defaults for the group's size, one slot.
  ParameterValues parameters(const BodyGroup& group);
  const Box3& boxOf(std::size_t body) const { return prepared_.boxOf(body); }
  /// Holds all that is nearer to the group than its required clearance, somewhere on the path.
  Box3 sweptBy(const BodyGroup& group, const std::vector<PathPoint>& path);

 private:
  /// Bodies of a group that move past the other one together: for all it is the same mesh, and screwed to all or none.
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
  std::mutex mutex_;  ///< of what follows
  std::map<BodyGroup, MovingObject> objects_;
  std::map<std::size_t, std::vector<std::size_t>> touched_;  ///< of bodies with forbidden directions
  /// By the mesh of a whole group: some of its bodies as they are taken against an obstacle.
  std::map<MeshPtr, std::map<std::pair<BodyGroup, std::vector<MeshPtr>>, MeshPtr>> joined_;
};

/// Obstacles of a motion world become bodies of the product.
void nameByProduct(MotionCertificate& certificate, const std::vector<std::size_t>& bodies);

}  // namespace glissade
