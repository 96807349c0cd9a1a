#include "engine/sequence/solid_mass.h"

#include <cmath>

namespace glissade {

SolidMass solidMass(const TriangleMesh& mesh) {
  constexpr double kLeastShare = 1e-9;  // share of the bounding box's volume
  const Box3 box = boundingBox(mesh);
  const Vector3 middle = box.center();
  double sixfold = 0.0;
  Vector3 moment = Vector3::Zero();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3 u = mesh.vertices[a] - middle;
    const Vector3 v = mesh.vertices[b] - middle;
    const Vector3 w = mesh.vertices[c] - middle;
    const double part = u.dot(v.cross(w));
    sixfold += part;
    moment += part * (u + v + w) / 4.0;
  }
  SolidMass mass{std::abs(sixfold) / 6.0, middle};
  if (mass.volume <= kLeastShare * box.sizes().prod()) return {0.0, middle};
  const Vector3 centre = middle + moment / sixfold;
  if (box.contains(centre)) mass.centre = centre;
  return mass;
}

}  // namespace glissade
