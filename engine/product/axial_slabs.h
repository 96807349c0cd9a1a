#pragma once

#include <vector>

#include "engine/geometry/triangle_tree.h"

namespace glissade {

/// A line that a body is looked at about.
struct AxisLine {
  Vector3 point = Vector3::Zero();
  Vector3 direction = Vector3::UnitZ();  ///< unit

  double heightOf(const Vector3& p) const { return direction.dot(p - point); }
  double distanceOf(const Vector3& p) const { return (p - point).cross(direction).norm(); }
};

/// The axis in the frame W, given in the frame B.
AxisLine transformed(const AxisLine& axis_B, const Pose& X_WB);

/// Directions about the axis in which a slab is looked at, evenly spaced.
inline constexpr int kAxialAngles = 72;

/// Where the surface of a body is about an axis, between two heights between which it stays about the same.
struct AxialSlab {
  double low = 0.0;  ///< along the axis, from its point
  double high = 0.0;
  bool isSolid = false;         ///< the axis is in the body
  std::vector<double> nearest;  ///< metres from the axis to the surface, of each direction; infinity: none within reach
  std::vector<double> farthest;  ///< the last surface within reach; 0: none

  double length() const { return high - low; }
  /// Share of the directions in which there is a surface within reach.
  double surroundedShare() const;
  /// The distance of the nearest surface that so large a share of these directions does not reach; infinity: none.
  double nearestAt(double share) const;
  double outerMost() const;
  /// Of the directions in which there is a surface.
  double outerLeast() const;
};

/// Part of an axis and how far about it is looked.
struct AxialReach {
  double low = 0.0;
  double high = 0.0;
  double radius = 0.0;
};

/// A mesh that can be looked at about any axis. The mesh should be closed; normals of one that is inside out are
/// turned.
class AxialMesh {
 public:
  explicit AxialMesh(const TriangleMesh& mesh);

  const TriangleTree& tree() const { return tree_; }
  /// About an axis in the body's frame, from low to high without gaps. Ends of slabs are where the mesh has corners; of
  /// many, evenly spaced.
  std::vector<AxialSlab> slabsAbout(const AxisLine& axis, const AxialReach& reach) const;
  /// By the parity of a ray.
  bool contains(const Vector3& p) const;
  /// Share of directions in which a point at this height and distance from the axis is in the body.
  double filledShare(const AxisLine& axis, double height, double radius) const;

 private:
  TriangleTree tree_;
  double sense_;
};

}  // namespace glissade
