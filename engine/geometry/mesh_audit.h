#pragma once

#include <cstddef>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A connected set of triangles, by shared vertices (equal positions count as one). A surface that does not touch a
/// solid is inside it if and only if any one of its points is.
struct ConnectedSurface {
  Vector3 point;  ///< one of its vertices
  Box3 box;
};

/// Properties of a mesh as a solid. Vertices with equal positions count as one.
struct MeshAudit {
  std::size_t triangles = 0;
  std::size_t degenerateTriangles = 0;  ///< triangles of zero area
  std::size_t openEdges = 0;            ///< edges with one triangle, or an odd number
  bool consistentlyOriented = true;     ///< each edge is used once in each direction
  double volume = 0.0;                  ///< signed volume, cubic metres; defined for a closed mesh
  Box3 box;
  /// Surfaces of triangles that are not degenerate, in the order of their first triangles.
  std::vector<ConnectedSurface> surfaces;

  /// True if the surface is closed. It then bounds a solid, and being inside it is a collision.
  bool closed() const { return openEdges == 0 && triangles > 0; }
};

MeshAudit audit(const TriangleMesh& mesh);

/// Same as audit(mesh).closed(), but faster.
bool isClosedSurface(const TriangleMesh& mesh);

/// Generalised winding number of the mesh about p (Jacobson et al. 2013; solid angles by van
/// Oosterom and Strackee 1983): +-1 inside a closed surface, 0 outside.
double windingNumber(const TriangleMesh& mesh, const Vector3& p);

/// True if p lies inside the solid that a closed mesh bounds; the orientation of the mesh does not matter. Undefined on
/// the surface itself.
bool containsPoint(const TriangleMesh& closedMesh, const Vector3& p);

}  // namespace glissade
