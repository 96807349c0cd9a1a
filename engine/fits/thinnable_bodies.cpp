#include "engine/fits/thinnable_bodies.h"

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
  std::tuple key{mesh, allowances, share};
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = thinned_.find(key); known != thinned_.end()) return known->second;
  }
  MeshPtr thinner;
  if (const ThinnableMesh* thinnable = of(mesh)) {
    if (auto made = thinnable->thinned(allowances, share)) {
      thinner = std::make_shared<const TriangleMesh>(std::move(*made));
    }
  }
  const std::lock_guard lock(mutex_);
  return thinned_.try_emplace(std::move(key), std::move(thinner)).first->second;
}

}  // namespace glissade
