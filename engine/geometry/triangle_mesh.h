#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/geometry/pose.h"

namespace glissade {

using TriangleIndices = std::array<std::uint32_t, 3>;

/// An indexed triangle mesh in its body's frame B, metres, counter-clockwise seen from outside.
/// A value; published as `MeshPtr` once built.
struct TriangleMesh {
  std::vector<Vector3> vertices;
  std::vector<TriangleIndices> triangles;

  bool empty() const { return triangles.empty(); }
};

using MeshPtr = std::shared_ptr<const TriangleMesh>;

Box3 boundingBox(const TriangleMesh& mesh);
/// Bounding box of the mesh placed at X_WB.
Box3 boundingBox(const TriangleMesh& mesh, const Pose& X_WB);
/// Largest distance of a vertex from the frame's origin.
double radiusAboutOrigin(const TriangleMesh& mesh);
/// Unit normal of a triangle, to its outer side; z where it has no area.
Vector3 faceNormal(const TriangleMesh& mesh, const TriangleIndices& triangle);
/// The mesh with every vertex moved by X_AB.
TriangleMesh transformed(const TriangleMesh& mesh, const Pose& X_AB);
TriangleMesh scaled(const TriangleMesh& mesh, const Vector3& factors);
void append(TriangleMesh& target, const TriangleMesh& addition);
/// Vertices with bit-equal positions merged, unreferenced ones dropped, degenerate triangles (two
/// equal corners) removed; the order of first appearance is kept.
TriangleMesh welded(const TriangleMesh& mesh);

}  // namespace glissade
