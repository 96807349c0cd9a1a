#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// How fast the points of the object move. Immutable, shared by threads.
class MotionBound {
 public:
  explicit MotionBound(const TriangleMesh& object);

  /// Largest speed of any point of the object over the straight motion, in metres per unit of t:
  /// |dp| + angle * (largest distance of a vertex from the axis of rotation through the reference
  /// point).
  double operator()(const Pose& from, const Pose& to) const;
  /// Largest distance of a point of the object from its reference point.
  double objectRadius() const { return clusters_.empty() ? 0.0 : clusters_.front().farthest; }

 private:
  /// Vertices that lie together, farthest from the reference point first: few are looked into.
  struct Cluster {
    Vector3 centre;
    double radius;
    double farthest;  ///< from the reference point
    std::vector<Vector3> vertices;
  };

  double squaredArm(const Vector3& axis) const;

  std::vector<Cluster> clusters_;
};

/// The straight motion's velocity, per unit of t: constant in the world for the reference point, and in
/// the object's own frame for the turn.
struct Velocity {
  Vector3 translation_W = Vector3::Zero();  ///< metres
  double rotation = 0.0;                    ///< radians, in [0, pi]
  Vector3 axis_B = Vector3::UnitX();        ///< unit

  Velocity(const Pose& from, const Pose& to);
};

}  // namespace glissade
