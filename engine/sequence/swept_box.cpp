#include "engine/sequence/swept_box.h"

#include <algorithm>

namespace glissade {

/// A translation is enclosed by the boxes at its ends; any other motion by the radius about the reference point.
Box3 sweptBox(const TriangleMesh& mesh, const std::vector<Pose>& path) {
  const Vector3 radius = Vector3::Constant(radiusAboutOrigin(mesh) * (1.0 + 1e-9));
  Box3 box;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool turns = i + 1 < path.size() && path[i].orientation.coeffs() != path[i + 1].orientation.coeffs();
    const bool turned = i > 0 && path[i].orientation.coeffs() != path[i - 1].orientation.coeffs();
    if (turns || turned) {
      box.extend(Box3(path[i].position - radius, path[i].position + radius));
    } else {
      box.extend(boundingBox(mesh, path[i]));
    }
  }
  return box;
}

}  // namespace glissade
