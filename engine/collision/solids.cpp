#include "engine/collision/solids.h"

#include <algorithm>
#include <map>

#include "engine/geometry/mesh_audit.h"

namespace glissade {
namespace {

/// Smallest extents first: a box fits into another, however turned, only if its smallest extents do
/// not exceed the other's diagonal; the plain diagonal test is enough to exclude nearly all pairs.
bool mayFit(const Box3& inner, const Box3& outer) { return inner.sizes().maxCoeff() <= outer.diagonal().norm(); }

}  // namespace

Solids::Solids(const std::vector<RigidBody>& obstacles, const TriangleMesh& object)
    : Solids(makeSolids(obstacles), prepare(object)) {}

Solids::Solids(const Solids& other, const TriangleMesh& object) : Solids(other.obstacles_, prepare(object)) {}

Solids::Solids(const Solids& other, const std::vector<RigidBody>& before, const std::vector<RigidBody>& obstacles,
               const TriangleMesh* object)
    : Solids(makeSolids(obstacles, before, *other.obstacles_), object != nullptr ? prepare(*object) : other.object_) {}

Solids::Solids(const SolidPtr& obstacle, SolidPtr object)
    : Solids(std::make_shared<const std::vector<SolidPtr>>(1, obstacle), std::move(object)) {}

Solids::Solids(SolidsPtr obstacles, SolidPtr object) : obstacles_(std::move(obstacles)), object_(std::move(object)) {
  if (object_->box.isEmpty()) return;
  squaredReach_ = object_->box.min().cwiseAbs().cwiseMax(object_->box.max().cwiseAbs()).squaredNorm();
  for (const Component& component : object_->components) {
    Guest guest{component.point, {}};
    for (std::size_t i = 0; i < obstacles_->size(); ++i) {
      const Solid& obstacle = *(*obstacles_)[i];
      if (obstacle.interior && mayFit(component.box, obstacle.box)) guest.hosts.push_back(i);
    }
    if (!guest.hosts.empty()) guests_.push_back(std::move(guest));
  }
  for (std::size_t i = 0; object_->interior && i < obstacles_->size(); ++i) {
    for (const Component& component : (*obstacles_)[i]->components) {
      if (mayFit(component.box, object_->box)) cores_.push_back({component.point, i});
    }
  }
}

Solids::SolidsPtr Solids::makeSolids(const std::vector<RigidBody>& bodies) { return makeSolids(bodies, {}, {}); }

Solids::SolidsPtr Solids::makeSolids(const std::vector<RigidBody>& bodies, const std::vector<RigidBody>& before,
                                     const std::vector<SolidPtr>& known) {
  std::multimap<const TriangleMesh*, std::size_t> byMesh;
  for (std::size_t i = 0; i < before.size(); ++i) byMesh.emplace(before[i].mesh.get(), i);
  auto solids = std::make_shared<std::vector<SolidPtr>>();
  solids->reserve(bodies.size());
  for (const RigidBody& body : bodies) {
    const auto [first, last] = byMesh.equal_range(body.mesh.get());
    const auto same =
        std::find_if(first, last, [&](const auto& entry) { return before[entry.second].X_WB == body.X_WB; });
    solids->push_back(same != last ? known[same->second] : prepare(transformed(*body.mesh, body.X_WB)));
  }
  return solids;
}

Solids::SolidPtr Solids::prepare(const TriangleMesh& mesh) {
  Solid solid;
  solid.box = boundingBox(mesh);
  const MeshAudit report = audit(mesh);
  if (report.closed()) solid.interior.emplace(mesh, report.consistentlyOriented);
  for (const TriangleMesh& component : connectedComponents(mesh)) {
    solid.components.push_back({component.vertices.front(), boundingBox(component)});
  }
  return std::make_shared<const Solid>(std::move(solid));
}

std::optional<int> Solids::containment(const Pose& X_WB) const {
  const std::size_t none = obstacles_->size();
  const std::size_t lowest = insideObject(X_WB, aroundObject(X_WB, none));
  return lowest < none ? std::optional<int>(static_cast<int>(lowest)) : std::nullopt;
}

std::size_t Solids::aroundObject(const Pose& X_WB, std::size_t limit) const {
  for (const Guest& guest : guests_) {
    const Vector3 point = X_WB * guest.point;
    for (const std::size_t host : guest.hosts) {
      if (host >= limit) break;
      if ((*obstacles_)[host]->interior->contains(point)) limit = host;
    }
  }
  return limit;
}

std::size_t Solids::insideObject(const Pose& X_WB, std::size_t limit) const {
  constexpr double kRounding = 1.0 + 1e-9;
  for (const Core& core : cores_) {
    if (core.obstacle >= limit) break;
    if ((core.point - X_WB.position).squaredNorm() > kRounding * squaredReach_) continue;
    if (object_->interior->contains(inverse(X_WB) * core.point)) return core.obstacle;
  }
  return limit;
}

}  // namespace glissade
