#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "engine/files/scenario_io.h"
#include "engine/geometry/triangle_mesh.h"
#include "tests/engine/support/directories.h"

namespace glissade::test {

/// The scenario with its bodies; fails the test where it cannot be loaded.
inline LoadedScenario loadedFrom(const Scenario& scenario) {
  auto loaded = loadGeometry(scenario, ".", "");
  EXPECT_TRUE(loaded.ok()) << toString(loaded.error());
  return std::move(*loaded);
}

/// A scenario of the samples; fails the test where it cannot be loaded.
inline LoadedScenario loadedSample(const std::string& name) {
  auto loaded = loadScenario(sourceDirectory() + "/samples/" + name + "/scenario.json");
  EXPECT_TRUE(loaded.ok()) << toString(loaded.error());
  return std::move(*loaded);
}

/// The bounding box of a body in world coordinates; fails the test where there is no such body.
inline Box3 worldBox(const LoadedScenario& loaded, const std::string& id) {
  if (loaded.object.id.text() == id) return boundingBox(*loaded.object.mesh, loaded.problem.start);
  for (const RigidBody& body : loaded.obstacles) {
    if (body.id.text() == id) return boundingBox(*body.mesh, body.X_WB);
  }
  ADD_FAILURE() << "no body " << id;
  return {};
}

}  // namespace glissade::test
