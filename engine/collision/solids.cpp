#include "engine/collision/solids.h"

#include <algorithm>

namespace glissade {
namespace {

/// True if the inner box may fit into the outer one, however it is turned: its extents must not exceed the other's
/// diagonal. This excludes nearly all pairs.
bool mayFit(const Box3& inner, const Box3& outer) { return inner.sizes().maxCoeff() <= outer.diagonal().norm(); }

}  // namespace

Solids::Solids(std::vector<Placed> obstacles, SolidPtr object)
    : Solids(std::make_shared<const std::vector<Placed>>(std::move(obstacles)), std::move(object)) {}

Solids::Solids(const Solids& other, const TriangleMesh& object) : Solids(other.obstacles_, prepare(object)) {}

Solids::Solids(PlacedPtr obstacles, SolidPtr object) : obstacles_(std::move(obstacles)), object_(std::move(object)) {
  if (object_->box.isEmpty()) return;
  squaredReach_ = object_->box.min().cwiseAbs().cwiseMax(object_->box.max().cwiseAbs()).squaredNorm();
  for (const ConnectedSurface& surface : object_->surfaces) {
    Guest guest{surface.point, {}};
    for (std::size_t i = 0; i < obstacles_->size(); ++i) {
      const Solid& obstacle = *(*obstacles_)[i].solid;
      if (obstacle.interior && mayFit(surface.box, obstacle.box)) guest.hosts.push_back(i);
    }
    if (!guest.hosts.empty()) guests_.push_back(std::move(guest));
  }
  for (std::size_t i = 0; object_->interior && i < obstacles_->size(); ++i) {
    const Placed& obstacle = (*obstacles_)[i];
    for (const ConnectedSurface& surface : obstacle.solid->surfaces) {
      if (mayFit(surface.box, object_->box)) cores_.push_back({obstacle.X_WS * surface.point, i});
    }
  }
}

Solids::SolidPtr Solids::prepare(const TriangleMesh& mesh) {
  Solid solid;
  solid.box = boundingBox(mesh);
  MeshAudit report = audit(mesh);
  if (report.closed()) solid.interior.emplace(mesh, report.consistentlyOriented);
  solid.surfaces = std::move(report.surfaces);
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
      const Placed& placed = (*obstacles_)[host];
      if (!placed.box_W.contains(point)) continue;
      if (placed.solid->interior->contains(inverse(placed.X_WS) * point)) limit = host;
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
