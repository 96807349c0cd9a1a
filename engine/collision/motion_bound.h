#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// Upper bound of the speed of the object's points. Immutable, shared by threads.
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
  /// Neighbouring vertices. The clusters are sorted by falling distance from the reference point, so that few are
  /// searched.
  struct Cluster {
    Vector3 centre;
    double radius;
    double farthest;  ///< largest distance from the reference point
    std::vector<Vector3> vertices;
  };

  double squaredArm(const Vector3& axis) const;

  std::vector<Cluster> clusters_;
};

/// The velocity of a straight motion, per unit of t. It is constant in the world for the reference point, and in the
/// object's own frame for the turn.
struct Velocity {
  Vector3 translation_W = Vector3::Zero();  ///< translation, metres
  double rotation = 0.0;                    ///< angle in radians, in [0, pi]
  Vector3 axis_B = Vector3::UnitX();        ///< unit axis of rotation

  Velocity(const Pose& from, const Pose& to);
};

}  // namespace glissade
