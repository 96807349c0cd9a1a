#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
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
  /// or no room. A thinned mesh of many triangles that nobody holds any more is made again.
  MeshPtr thinned(const MeshPtr& mesh, const std::vector<double>& allowances, double share = kMostThinning);

 private:
  struct Entry {
    std::once_flag made;
    std::optional<ThinnableMesh> thinnable;
  };
  std::mutex mutex_;  ///< protects the members below
  std::map<MeshPtr, std::unique_ptr<Entry>> entries_;
  struct Thinned {
    std::weak_ptr<const TriangleMesh> mesh{};
    MeshPtr kept{};       ///< keeps a mesh of few triangles
    bool hasRoom = true;  ///< false: it is known that there is no mesh
  };
  /// By the mesh, the hash of the allowances, and the share. Kept allowances and unused meshes were most of the memory
  /// of the fits of fine meshes.
  std::map<std::tuple<MeshPtr, std::string, double>, Thinned> thinned_;
};

}  // namespace glissade
