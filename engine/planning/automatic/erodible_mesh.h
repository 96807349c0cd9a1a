#pragma once

#include <vector>

#include "engine/geometry/triangle_mesh.h"

namespace glissade {

/// A mesh whose surface moves inwards or outwards: every vertex goes to where the moved planes of its
/// faces meet, in the least squares' sense where there are more than three of them. Where the body is
/// thin it keeps a fifth of its thickness. For searches in an easier space only: sharp edges move by
/// less than they should, and the result may intersect itself. Immutable, shared by threads.
class ErodibleMesh {
 public:
  /// Measures how thick the body is below each face.
  explicit ErodibleMesh(const TriangleMesh& mesh);

  /// The mesh with its surface moved inwards by `depth` (metres; negative: outwards).
  TriangleMesh eroded(double depth) const;

 private:
  struct Face {
    Vector3 normal;  ///< outwards
    double area;     ///< twice
    double room;     ///< how far it may go inwards
  };

  TriangleMesh mesh_;        ///< welded
  std::vector<Face> faces_;  ///< of its triangles
};

}  // namespace glissade
