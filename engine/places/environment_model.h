#pragma once

#include <memory>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/places/topological_map.h"

namespace glissade {

/// Options of the environment model; kept in the scenario.
struct EnvironmentOptions {
  double cellSize = 0.0;                      ///< size of the octree's finest cells, metres; 0: by memory
  double memory = 16.0;                       ///< MiB for the octree where cellSize is 0
  int topologyLevel = 7;                      ///< level of the cells of places, at most the octree's depth
  std::string identifier = "region-growing";  ///< id of the place identifier in its registry

  friend bool operator==(const EnvironmentOptions&, const EnvironmentOptions&) = default;
};

/// The geometrical and topological layers of paper 2 for one placement of the bodies. Immutable,
/// shared by threads.
struct EnvironmentModel {
  EnvironmentOptions options;
  std::shared_ptr<const Octree> octree;
  FreeSpace space;
  TopologicalMap map;
  std::vector<bool> cluttered;    ///< one entry per place: mobile bodies reach into it
  std::vector<double> clearance;  ///< distance of each cell to the nearest cell with any body, metres
  TriangleMesh statics_W;         ///< the static bodies, world frame
};
using EnvironmentModelPtr = std::shared_ptr<const EnvironmentModel>;

/// Builds the model. Errors: MalformedInput for an unknown identifier or an option out of range; Interrupted after a
/// stop, which is also checked inside the layers.
Result<EnvironmentModelPtr> buildEnvironment(const std::vector<RigidBody>& bodies, const Box3& workspace,
                                             const EnvironmentOptions& options, const StopToken& stop = {});

/// The model with the bodies at their present poses. Where only mobile bodies have moved since `before` was built,
/// places and borders stay, and of the octree only the cells that a body leaves or enters are rebuilt (paper 2, section
/// 5.1.2). The result is the same model as one built anew with cells of that size. In other cases the same as
/// buildEnvironment.
Result<EnvironmentModelPtr> updateEnvironment(const EnvironmentModel& before, const std::vector<RigidBody>& bodies,
                                              const Box3& workspace, const EnvironmentOptions& options,
                                              const StopToken& stop = {});

/// Diagnostic for a stop of buildEnvironment, or of a computation on its model.
Diagnostic environmentInterrupted();

}  // namespace glissade
