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

/// Prepares meshes for thinning and thins them, each once. Thread-safe. Bodies with the same mesh and the same fits
/// share the thinned mesh.
class ThinnableBodies {
 public:
  /// Null if the mesh encloses nothing. Valid as long as this object.
  const ThinnableMesh* of(const MeshPtr& mesh);
  /// Thins by an allowance for each triangle, metres; `share`: see ThinnableMesh. Null if the mesh has no inside there,
  /// or no room.
  MeshPtr thinned(const MeshPtr& mesh, const std::vector<double>& allowances, double share = kMostThinning);

 private:
  struct Entry {
    std::once_flag made;
    std::optional<ThinnableMesh> thinnable;
  };
  std::mutex mutex_;  ///< protects the members below
  std::map<MeshPtr, std::unique_ptr<Entry>> entries_;
  std::map<std::tuple<MeshPtr, std::vector<double>, double>, MeshPtr> thinned_;
};

}  // namespace glissade
