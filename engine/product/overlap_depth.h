#pragma once

#include <functional>
#include <optional>

#include "engine/geometry/solid_interior.h"
#include "engine/geometry/triangle_tree.h"

namespace glissade {

/// A closed mesh in the world, for measuring how deep others are in it.
class SolidDepth {
 public:
  /// Nothing where the mesh is not closed.
  static std::optional<SolidDepth> of(const TriangleMesh& mesh_W);

  bool contains(const Vector3& p) const { return interior_.contains(p); }
  /// Thickness of the body below a triangle, along its normal: metres, infinity where nothing is opposite.
  double thicknessBelow(const Triangle& triangle) const;

 private:
  SolidDepth(const TriangleMesh& mesh_W, bool oriented, double sense);

  SolidInterior interior_;
  TriangleTree rays_;
  double sense_;  ///< 1 where triangles run counter-clockwise seen from outside, else -1
  double beyond_;
};

/// How deep a surface is in a body at most.
struct OverlapDepth {
  double depth = 0.0;          ///< metres
  std::uint32_t triangle = 0;  ///< of the body, nearest to the deepest sample
};

/// Samples the triangles of `surface` where they may be inside the body and takes the largest distance of a sample
/// inside from the surface of the body; nothing where that is not above `floor` (metres, >= 0). Never more than the
/// true depth; short of it by up to the spacing of the samples, a twentieth of the common box's diagonal. Triangles
/// that are known to coincide with the surface of the body are sampled at their corners and middle only.
std::optional<OverlapDepth> depthInside(const TriangleTree& surface, const TriangleTree& body, const SolidDepth& solid,
                                        double floor, const std::function<bool(std::uint32_t)>& isCoincident);

}  // namespace glissade
