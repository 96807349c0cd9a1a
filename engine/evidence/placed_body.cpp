#include "engine/evidence/placed_body.h"

#include <algorithm>

#include "engine/geometry/mesh_edges.h"

namespace glissade::evidence {

PlacedBody::PlacedBody(const Body& body, const Pose& X_WB)
    : mesh(transformed(*body.mesh, X_WB)),
      tree(mesh),
      regions(faceRegionsOf(mesh)),
      spacing(body.spacing),
      radius(radiusAboutOrigin(*body.mesh)),
      halfDiagonal(0.5 * boundingBox(*body.mesh).diagonal().norm()) {
  const TriangleMesh whole = welded(mesh);
  const EdgeFacts edges = edgeFactsOf(whole);
  if (edges.open == 0) interior.emplace(whole, edges.consistentlyOriented);
  double volume = 0.0;
  const Vector3 middle = tree.box().center();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = tree.triangles()[t];
    volume += (a - middle).dot((b - middle).cross(c - middle));
    const Vector3 doubled = (b - a).cross(c - a);
    normals.emplace_back(doubled.norm() > 0.0 ? Vector3(doubled.normalized()) : Vector3(Vector3::Zero()));
    const bool stated = !mesh.faces.empty();
    deflections.push_back(stated ? mesh.deflectionOf(t) : (regions.curved[t] ? body.deflection : 0.0));
    largestDeflection = std::max(largestDeflection, deflections.back());
  }
  for (Vector3& normal : normals) normal *= volume < 0.0 ? -1.0 : 1.0;
  rounds = roundFacesOf(*this);
}

}  // namespace glissade::evidence
