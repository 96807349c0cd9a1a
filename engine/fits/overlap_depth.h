#pragma once

#include <functional>
#include <optional>

#include "engine/geometry/solid_interior.h"
#include "engine/geometry/triangle_tree.h"

namespace glissade {

/// A closed mesh in the world frame, for measuring the depth of other bodies in it.
class SolidDepth {
 public:
  /// Nothing if the mesh is not closed.
  static std::optional<SolidDepth> of(const TriangleMesh& mesh_W);

  bool contains(const Vector3& p) const { return interior_.contains(p); }
  /// Thickness of the body below a triangle, along its normal, metres; infinity if no face is opposite.
  double thicknessBelow(const Triangle& triangle) const;

 private:
  SolidDepth(const TriangleMesh& mesh_W, bool oriented, double sense);

  SolidInterior interior_;
  TriangleTree rays_;
  double sense_;  ///< 1 if triangles run counter-clockwise seen from outside, else -1
  double beyond_;
};

/// The largest depth of a surface in a body.
struct OverlapDepth {
  double depth = 0.0;          ///< metres
  std::uint32_t triangle = 0;  ///< triangle of the body nearest to the deepest sample
};

/// Samples the triangles of `surface` inside the body, and returns the largest distance of a sample from the body's
/// surface; nothing if that is not above `floor` (metres, >= 0). The result never exceeds the true depth, and is less
/// by up to the spacing of the samples, a twentieth of the common box's diagonal. Triangles that coincide with the
/// surface of the body are sampled at their corners and centre only.
std::optional<OverlapDepth> depthInside(const TriangleTree& surface, const TriangleTree& body, const SolidDepth& solid,
                                        double floor, const std::function<bool(std::uint32_t)>& isCoincident);

}  // namespace glissade
