#pragma once

#include <memory>
#include <vector>

#include "engine/collision/forbidden_motions.h"
#include "engine/places/rigid_body.h"

namespace glissade {

/// A body of a group, with the directions that are forbidden to it while it is beside other bodies.
struct DirectedBody {
  MeshPtr mesh;
  Pose X_GB;                        ///< pose in the frame of the group
  std::vector<Vector3> directions;  ///< unit, world frame
  std::vector<RigidBody> beside;    ///< bodies that it touched at the start
  double apart = 0.0;               ///< distance of the convex hulls, metres, from which every direction is allowed
};

/// Keeps a group out of directions that a person forbids. Until the convex hull of a body is clear of those of the
/// bodies that it touched at the start, neither a piece of its motion nor the displacement from the start is within
/// tolerance::kForbiddenCone of the direction. The motion of a body is that of its bounding box's centre.
class DirectionRule final : public ForbiddenMotions {
 public:
  /// `start`: pose of the group's frame where the product is assembled.
  DirectionRule(const Pose& start, std::vector<DirectedBody> bodies);

  bool mayBeAt(const Pose& X_WG) const override;
  bool mayMove(const Pose& from, const Pose& to) const override;

 private:
  struct Directed {
    DirectedBody body;
    Vector3 middle_G;
    std::vector<Box3> boxes;  ///< bounding boxes of `beside`, world frame
    double reach = 0.0;       ///< largest distance of the body's vertices from its middle
  };
  static bool isForbidden(const Directed& each, const Vector3& way);
  bool isAtStart(const Directed& each, const Pose& X_WG) const;
  bool wayIsForbidden(const Directed& each, const Pose& X_WG) const;
  static bool isClear(const Directed& each, const Pose& X_WG);

  Pose start_;
  std::vector<Directed> bodies_;
};

}  // namespace glissade
