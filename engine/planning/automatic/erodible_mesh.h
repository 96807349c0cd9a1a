#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A mesh whose surface moves inwards or outwards. Every vertex moves to the intersection of the moved planes of its
/// faces, in the least squares sense where there are more than three. Thin bodies keep a fifth of their thickness. Only
/// for searches in an easier space: sharp edges move by less than they should, and the result may intersect itself.
/// Immutable, shared by threads.
class ErodibleMesh {
 public:
  /// Measures the thickness of the body below each face.
  explicit ErodibleMesh(const TriangleMesh& mesh);

  /// The mesh with its surface moved inwards by `depth` (metres; negative: outwards).
  TriangleMesh eroded(double depth) const;

 private:
  struct Face {
    Vector3 normal;  ///< outward normal
    double area;     ///< twice the area of the triangle
    double room;     ///< largest distance by which the face may move inwards, metres
  };

  TriangleMesh mesh_;        ///< welded copy of the mesh
  std::vector<Face> faces_;  ///< one face for each triangle of the mesh
};

}  // namespace glissade
