#pragma once

#include <cstdint>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A vertex of a cone that continues a cylinder and recedes from it, as the chamfer at the end of a bolt or at the
/// mouth of a hole does. When the cylinder is thinned, the vertex may lie beyond the thinned cylinder.
struct ConeVertex {
  std::uint32_t vertex = 0;
  std::uint32_t cylinder = 0;          ///< index into the faces of the mesh
  Vector3 inwards = Vector3::UnitX();  ///< unit vector into the body, perpendicular to the axis
  double recedes = 0.0;                ///< distance from the cylinder, perpendicular to the axis, metres, >= 0
};

/// The vertices of cones and cylinders that the file states with a common axis, where the cone begins at the end of the
/// cylinder. Sorted by cylinder, then by vertex.
std::vector<ConeVertex> coneVertices(const TriangleMesh& mesh);

/// Moves the vertices of cones perpendicular to the axis onto the thinned cylinder where they are beyond it. `taken`:
/// thinning of each face of the mesh, metres; `moves`: move of each vertex. Where no vertex is between the cylinder and
/// the thinned one, the edge between cylinder and cone slides along the cone, and its move is unchanged.
void moveCones(const std::vector<ConeVertex>& vertices, const std::vector<double>& taken, std::vector<Vector3>& moves);

}  // namespace glissade
