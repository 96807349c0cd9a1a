#include "engine/collision/solids.h"

#include "engine/geometry/mesh_audit.h"

namespace glissade {
namespace {

/// Smallest extents first: a box fits into another, however turned, only if its smallest extents do
/// not exceed the other's diagonal; the plain diagonal test is enough to exclude nearly all pairs.
bool mayFit(const Box3& inner, const Box3& outer) { return inner.sizes().maxCoeff() <= outer.diagonal().norm(); }

}  // namespace

Solids::Solids(const std::vector<RigidBody>& obstacles, const TriangleMesh& object)
    : obstacles_(std::make_shared<const std::vector<Solid>>(makeSolids(obstacles))), object_(makeSolid(object)) {}

Solids::Solids(const Solids& other, const TriangleMesh& object)
    : obstacles_(other.obstacles_), object_(makeSolid(object)) {}

std::vector<Solids::Solid> Solids::makeSolids(const std::vector<RigidBody>& bodies) {
  std::vector<Solid> solids;
  for (const RigidBody& body : bodies) solids.push_back(makeSolid(transformed(*body.mesh, body.X_WB)));
  return solids;
}

Solids::Solid Solids::makeSolid(const TriangleMesh& mesh) {
  Solid solid;
  solid.box = boundingBox(mesh);
  const MeshAudit report = audit(mesh);
  if (report.closed()) solid.interior.emplace(mesh, report.consistentlyOriented);
  for (const TriangleMesh& component : connectedComponents(mesh)) {
    solid.components.push_back({component.vertices.front(), boundingBox(component)});
  }
  return solid;
}

std::optional<int> Solids::containment(const Pose& X_WB) const {
  const Pose X_BW = inverse(X_WB);
  const std::vector<Solid>& obstacles = *obstacles_;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (objectInside(obstacles[i], X_WB) || objectAround(obstacles[i], X_BW)) return static_cast<int>(i);
  }
  return std::nullopt;
}

bool Solids::objectInside(const Solid& obstacle, const Pose& X_WB) const {
  if (!obstacle.interior) return false;
  for (const Component& component : object_.components) {
    const Vector3 point = X_WB * component.point;
    if (!obstacle.box.contains(point) || !mayFit(component.box, obstacle.box)) continue;
    if (obstacle.interior->contains(point)) return true;
  }
  return false;
}

bool Solids::objectAround(const Solid& obstacle, const Pose& X_BW) const {
  if (!object_.interior) return false;
  for (const Component& component : obstacle.components) {
    const Vector3 point = X_BW * component.point;
    if (!object_.box.contains(point) || !mayFit(component.box, object_.box)) continue;
    if (object_.interior->contains(point)) return true;
  }
  return false;
}

}  // namespace glissade
