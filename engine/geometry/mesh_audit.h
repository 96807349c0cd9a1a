#pragma once

#include <cstddef>
#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// Triangles that hang together by shared vertices (equal positions count as one). A surface that does not touch a
/// solid is inside it if and only if any one of its points is.
struct ConnectedSurface {
  Vector3 point;  ///< one of its vertices
  Box3 box;
};

/// What a mesh is worth as a solid. Vertices with equal positions count as one.
struct MeshAudit {
  std::size_t triangles = 0;
  std::size_t degenerateTriangles = 0;  ///< zero area
  std::size_t openEdges = 0;            ///< edges with one triangle, or an uneven number
  bool consistentlyOriented = true;     ///< each edge is used once in each direction
  double volume = 0.0;                  ///< signed, cubic metres; meaningful where closed
  Box3 box;
  std::vector<ConnectedSurface> surfaces;  ///< of triangles that are not degenerate, in the order of the first ones

  /// A closed surface bounds a solid, and being inside it is a collision.
  bool closed() const { return openEdges == 0 && triangles > 0; }
};

MeshAudit audit(const TriangleMesh& mesh);

/// audit(mesh).closed(), in less time.
bool isClosedSurface(const TriangleMesh& mesh);

/// Generalised winding number of the mesh about p (Jacobson et al. 2013; solid angles by van
/// Oosterom and Strackee 1983): +-1 inside a closed surface, 0 outside.
double windingNumber(const TriangleMesh& mesh, const Vector3& p);

/// p lies inside the solid that a closed mesh bounds; the orientation of the mesh does not matter.
/// Not meaningful on the surface itself.
bool containsPoint(const TriangleMesh& closedMesh, const Vector3& p);

}  // namespace glissade
