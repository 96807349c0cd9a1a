#pragma once

#include <map>
#include <optional>

#include "engine/planning/automatic/erodible_mesh.h"
#include "engine/planning/problem.h"

namespace glissade {

/// The world with the object eroded by this or that depth, each built once. Not shared by threads.
class ErodedWorlds {
 public:
  explicit ErodedWorlds(CollisionWorldPtr world) : world_(std::move(world)) {}

  /// Depth in metres; 0: the world itself; negative: grown.
  CollisionWorldPtr at(double depth);

 private:
  CollisionWorldPtr world_;
  std::optional<ErodibleMesh> object_;  ///< once it is needed
  std::map<double, CollisionWorldPtr> built_;
};

}  // namespace glissade
