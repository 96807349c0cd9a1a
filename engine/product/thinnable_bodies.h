#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/geometry/thinned_mesh.h"

namespace glissade {

/// Meshes that are prepared once for being taken thinner, and taken thinner once, for any number of threads. Bodies
/// that have the same mesh and fit others alike share the thinned one.
class ThinnableBodies {
 public:
  /// Null where the mesh encloses nothing. Lives as long as this.
  const ThinnableMesh* of(const MeshPtr& mesh);
  /// With an allowance for each triangle, metres, and `share` as of ThinnableMesh. Null where the mesh has no inside
  /// there, or no place for that.
  MeshPtr thinned(const MeshPtr& mesh, const std::vector<double>& allowances, double share = kMostThinning);

 private:
  struct Entry {
    std::once_flag made;
    std::optional<ThinnableMesh> thinnable;
  };
  std::mutex mutex_;  ///< of what follows
  std::map<MeshPtr, std::unique_ptr<Entry>> entries_;
  std::map<std::tuple<MeshPtr, std::vector<double>, double>, MeshPtr> thinned_;
};

}  // namespace glissade
