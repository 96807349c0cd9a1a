#pragma once

#include <memory>

#include "engine/base/result.h"
#include "engine/base/stop_token.h"
#include "engine/environment/topological_map.h"

namespace glissade {

/// How the environment is modelled; kept in the scenario.
struct EnvironmentOptions {
  double cellSize = 0.0;                      ///< metres, of the octree's finest cells; 0: by memory
  double memory = 16.0;                       ///< MiB for the octree where cellSize is 0
  int topologyLevel = 7;                      ///< level of the cells that places consist of, at most the octree's depth
  std::string identifier = "region-growing";  ///< id in the place identifier registry

  friend bool operator==(const EnvironmentOptions&, const EnvironmentOptions&) = default;
};

/// The geometrical and topological layers of paper 2 for one placement of the bodies. Immutable,
/// shared by threads.
struct EnvironmentModel {
  EnvironmentOptions options;
  std::shared_ptr<const Octree> octree;
  FreeSpace space;
  TopologicalMap map;
  std::vector<bool> cluttered;    ///< per place: mobile bodies reach into it
  std::vector<double> clearance;  ///< per cell: to the nearest cell with any body, metres
  TriangleMesh statics_W;         ///< the static bodies, world
};
using EnvironmentModelPtr = std::shared_ptr<const EnvironmentModel>;

/// Unknown identifiers are ErrorKind::MalformedInput, as are options out of range. A stop is looked at
/// inside the layers, too, and ends in ErrorKind::Interrupted.
Result<EnvironmentModelPtr> buildEnvironment(const std::vector<RigidBody>& bodies, const Box3& workspace,
                                             const EnvironmentOptions& options, const StopToken& stop = {});

/// The model with the bodies where they are now. Where only mobile ones have moved since `before` was built,
/// places and borders stay, and of the octree only cells that a body leaves or enters are rebuilt (paper 2,
/// section 5.1.2): the same model as one built afresh with cells of that size. Else as buildEnvironment.
Result<EnvironmentModelPtr> updateEnvironment(const EnvironmentModel& before, const std::vector<RigidBody>& bodies,
                                              const Box3& workspace, const EnvironmentOptions& options,
                                              const StopToken& stop = {});

/// What a stop of buildEnvironment, or of what is computed from its model, is reported as.
Diagnostic environmentInterrupted();

}  // namespace glissade
