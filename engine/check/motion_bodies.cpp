#include "engine/check/motion_bodies.h"

#include <algorithm>

#include "engine/check/evidence_names.h"
#include "engine/evidence/thinning.h"

namespace glissade::check {
namespace {

double scaleOf(const std::vector<Body>& bodies) {
  std::vector<const TriangleMesh*> meshes;
  for (const Body& body : bodies) meshes.push_back(body.mesh.get());
  return MotionCheck::scaleFor(meshes, bodies);
}

}  // namespace

MotionBodies::MotionBodies(const std::vector<Body>& bodies, std::size_t keptTriangles)
    : scale_(scaleOf(bodies)), keptTriangles_(keptTriangles) {}

double MotionBodies::scaleFor(const std::vector<const TriangleMesh*>& meshes, const std::vector<Body>& placed) const {
  return std::max(scale_, MotionCheck::scaleFor(meshes, placed));
}

MeshPtr MotionBodies::taken(const MeshPtr& mesh, const std::vector<double>& allowances, double share,
                            const ThreadCore* core) {
  if (allowances.empty() && core == nullptr) return mesh;
  const std::tuple key{mesh, allowances, share, core != nullptr ? std::optional(*core) : std::nullopt};
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = thinned_.find(key); known != thinned_.end()) return known->second;
  }
  TriangleMesh made = allowances.empty() ? *mesh : thinned(*mesh, allowances, share);
  if (core != nullptr) made = withoutThread(made, *core);
  auto thin = std::make_shared<const TriangleMesh>(std::move(made));
  const std::lock_guard lock(mutex_);
  return thinned_.try_emplace(key, std::move(thin)).first->second;
}

MotionCheck::ObstaclePtr MotionBodies::obstacle(const MeshPtr& mesh, const Pose& X_WB, double scale) {
  const Vector3& p = X_WB.position;
  const Eigen::Vector4d q = X_WB.orientation.coeffs();
  const Place place{mesh, {p.x(), p.y(), p.z(), q[0], q[1], q[2], q[3], scale}};
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = obstacles_.find(place); known != obstacles_.end()) {
      known->second.askedAt = ++asked_;
      return known->second.obstacle;
    }
  }
  auto prepared = MotionCheck::prepare(*mesh, X_WB, scale);
  const std::lock_guard lock(mutex_);
  const auto [entry, isNew] = obstacles_.try_emplace(place, Prepared{std::move(prepared), ++asked_});
  MotionCheck::ObstaclePtr found = entry->second.obstacle;
  if (isNew) triangles_ += mesh->triangles.size();
  while (triangles_ > keptTriangles_ && obstacles_.size() > 1) forgetOldest();
  return found;
}

void MotionBodies::forgetOldest() {
  const auto oldest = std::min_element(obstacles_.begin(), obstacles_.end(), [](const auto& a, const auto& b) {
    return a.second.askedAt < b.second.askedAt;
  });
  triangles_ -= oldest->first.first->triangles.size();
  obstacles_.erase(oldest);
}

}  // namespace glissade::check
