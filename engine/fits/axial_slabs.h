#pragma once

#include <vector>

#include "engine/geometry/triangle_tree.h"

namespace glissade {

/// An axis about which a body is measured.
struct AxisLine {
  Vector3 point = Vector3::Zero();
  Vector3 direction = Vector3::UnitZ();  ///< unit

  double heightOf(const Vector3& p) const { return direction.dot(p - point); }
  double distanceOf(const Vector3& p) const { return (p - point).cross(direction).norm(); }
};

/// The axis in the frame W, given in the frame B.
AxisLine transformed(const AxisLine& axis_B, const Pose& X_WB);

/// Number of directions about the axis in which a slab is measured, evenly spaced.
inline constexpr int kAxialAngles = 72;

/// Distances of a body's surface from an axis, between two heights between which they hardly change.
struct AxialSlab {
  double low = 0.0;  ///< range along the axis, from its point
  double high = 0.0;
  bool isSolid = false;          ///< the axis is in the body
  std::vector<double> nearest;   ///< nearest surface in each direction, metres; infinity: none within reach
  std::vector<double> farthest;  ///< distance of the last surface within reach; 0: none

  double length() const { return high - low; }
  /// Share of the directions in which there is a surface within reach.
  double surroundedShare() const;
  /// The distance within which this share of these directions meets no surface; infinity: none.
  double nearestAt(double share) const;
  double outerMost() const;
  /// Least outer distance, among directions with a surface.
  double outerLeast() const;
};

/// The part of an axis that is measured, and the radius about it.
struct AxialReach {
  double low = 0.0;
  double high = 0.0;
  double radius = 0.0;
};

/// A mesh that can be measured about any axis. The mesh should be closed; inverted normals are corrected.
class AxialMesh {
 public:
  explicit AxialMesh(const TriangleMesh& mesh);

  const TriangleTree& tree() const { return tree_; }
  /// Slabs about an axis in the body's frame, from low to high without gaps. They end at the corners of the mesh, or
  /// are evenly spaced if there are many corners.
  std::vector<AxialSlab> slabsAbout(const AxisLine& axis, const AxialReach& reach) const;
  /// Decided by the parity of a ray.
  bool contains(const Vector3& p) const;
  /// Share of directions in which the point at this height and distance from the axis is in the body.
  double filledShare(const AxisLine& axis, double height, double radius) const;

 private:
  TriangleTree tree_;
  double sense_;
};

}  // namespace glissade
