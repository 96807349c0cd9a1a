#pragma once

#include <map>
#include <mutex>

#include "engine/planning/automatic/erodible_mesh.h"
#include "engine/planning/problem.h"

namespace glissade {

/// The world with the object and its variants eroded by a depth. Each depth is built once. Shared by threads: a thread
/// that asks for a depth waits while another thread builds one.
class ErodedWorlds {
 public:
  explicit ErodedWorlds(CollisionWorldPtr world) : world_(std::move(world)) {}

  /// `depth` in metres; 0: the world itself; negative: grown.
  CollisionWorldPtr at(double depth);
  /// Forgets the worlds of all other depths. Each has a copy of the object, which may take hundreds of megabytes.
  void keepOnly(double depth);

 private:
  std::mutex mutex_;  ///< guards objects_ and built_
  CollisionWorldPtr world_;
  std::map<const TriangleMesh*, ErodibleMesh> objects_;  ///< the object and its variants, created on demand
  std::map<double, CollisionWorldPtr> built_;
};

}  // namespace glissade
