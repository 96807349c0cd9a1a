#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A vertex of a cone that continues a cylinder and recedes from it, as the chamfer at the end of a bolt or at the
/// mouth of a hole does. Where the cylinder is taken thinner, the vertex is beyond the thinned cylinder or not.
struct ConeVertex {
  std::uint32_t vertex = 0;
  std::uint32_t cylinder = 0;          ///< index into the faces of the mesh
  Vector3 inwards = Vector3::UnitX();  ///< unit, into the body, across the axis
  double recedes = 0.0;                ///< metres, >= 0: from the cylinder, across the axis
};

/// Only cones and cylinders that the file states, about one axis, of which the one begins where the other ends. By
/// cylinders, then by vertices.
std::vector<ConeVertex> coneVertices(const TriangleMesh& mesh);

/// Moves the vertices of cones across the axis onto the thinned cylinder where they are beyond it. `taken`: metres that
/// each face of the mesh is taken thinner; `moves`: of each vertex. Where no vertex is between the cylinder and the
/// thinned one, the edge between cylinder and cone slides along the cone, and its move is left as it is.
void moveCones(const std::vector<ConeVertex>& vertices, const std::vector<double>& taken, std::vector<Vector3>& moves);

}  // namespace glissade
