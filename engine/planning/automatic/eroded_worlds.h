#pragma once

#include <map>
#include <mutex>

#include "engine/planning/automatic/erodible_mesh.h"
#include "engine/planning/problem.h"

namespace glissade {

/// The world with the object, and its variants, eroded by this or that depth, each built once. Shared by threads: one
/// that wants a depth waits while another is built.
class ErodedWorlds {
 public:
  explicit ErodedWorlds(CollisionWorldPtr world) : world_(std::move(world)) {}

  /// Depth in metres; 0: the world itself; negative: grown.
  CollisionWorldPtr at(double depth);
  /// Forgets the worlds of all other depths: each has a copy of the object, which may be hundreds of megabytes.
  void keepOnly(double depth);

 private:
  std::mutex mutex_;  ///< of what follows but the first
  CollisionWorldPtr world_;
  std::map<const TriangleMesh*, ErodibleMesh> objects_;  ///< the object and its variants, once they are needed
  std::map<double, CollisionWorldPtr> built_;
};

}  // namespace glissade
