#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/geometry/surface_face.h"

namespace glissade {

using TriangleIndices = std::array<std::uint32_t, 3>;

/// An indexed triangle mesh in its body's frame B, metres, counter-clockwise seen from outside.
/// A value; published as `MeshPtr` once built.
struct TriangleMesh {
  std::vector<Vector3> vertices;
  std::vector<TriangleIndices> triangles;
  std::vector<SurfaceFace> faces{};     ///< faces that the file states; empty where it holds triangles only
  std::vector<std::uint32_t> faceOf{};  ///< index into `faces` for each triangle; empty where `faces` is empty

  /// Largest distance of the triangle from its surface, metres; 0 where the file holds triangles only.
  double deflectionOf(std::size_t triangle) const { return faceOf.empty() ? 0.0 : faces[faceOf[triangle]].deflection; }
  bool empty() const { return triangles.empty(); }
};

using MeshPtr = std::shared_ptr<const TriangleMesh>;

Box3 boundingBox(const TriangleMesh& mesh);
/// Bounding box of the mesh placed at X_WB.
Box3 boundingBox(const TriangleMesh& mesh, const Pose& X_WB);
/// Largest distance of a vertex from the frame's origin.
double radiusAboutOrigin(const TriangleMesh& mesh);
/// Outward unit normal of a triangle; z where it has no area.
Vector3 faceNormal(const TriangleMesh& mesh, const TriangleIndices& triangle);
/// The mesh with its vertices and faces transformed by X_AB.
TriangleMesh transformed(const TriangleMesh& mesh, const Pose& X_AB);
/// The mesh scaled by a factor for each axis. Faces keep their kind where the three factors are equal, and are Free
/// otherwise.
TriangleMesh scaled(const TriangleMesh& mesh, const Vector3& factors);
/// Appends a mesh. If one of the two has faces, the triangles of the other become one face of kind Free without
/// deflection.
void append(TriangleMesh& target, const TriangleMesh& addition);
/// Vertices with bit-equal positions merged, unreferenced ones dropped, degenerate triangles (two
/// equal corners) removed; the order of first appearance is kept.
TriangleMesh welded(const TriangleMesh& mesh);

}  // namespace glissade
