#include "engine/fits/thinnable_bodies.h"

#include "engine/base/file.h"

namespace glissade {

const ThinnableMesh* ThinnableBodies::of(const MeshPtr& mesh) {
  Entry* entry = nullptr;
  {
    const std::lock_guard lock(mutex_);
    auto& known = entries_[mesh];
    if (!known) known = std::make_unique<Entry>();
    entry = known.get();
  }
  std::call_once(entry->made, [&] { entry->thinnable = ThinnableMesh::of(*mesh); });
  return entry->thinnable ? &*entry->thinnable : nullptr;
}

/// Two threads that need the same mesh may both make it; the first result is kept.
MeshPtr ThinnableBodies::thinned(const MeshPtr& mesh, const std::vector<double>& allowances, double share) {
  constexpr std::size_t kFewTriangles = 5000;
  const std::string bytes(reinterpret_cast<const char*>(allowances.data()), allowances.size() * sizeof(double));
  const std::tuple key{mesh, sha256(bytes), share};
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = thinned_.find(key); known != thinned_.end()) {
      if (!known->second.hasRoom) return nullptr;
      if (MeshPtr made = known->second.mesh.lock()) return made;
    }
  }
  MeshPtr thinner;
  if (const ThinnableMesh* thinnable = of(mesh)) {
    if (auto made = thinnable->thinned(allowances, share)) {
      thinner = std::make_shared<const TriangleMesh>(std::move(*made));
    }
  }
  const std::lock_guard lock(mutex_);
  Thinned& entry = thinned_[key];
  if (MeshPtr made = entry.mesh.lock()) return made;
  const bool isKept = thinner && thinner->triangles.size() <= kFewTriangles;
  entry = {thinner, isKept ? thinner : nullptr, thinner != nullptr};
  return thinner;
}

}  // namespace glissade
