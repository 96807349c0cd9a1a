#pragma once

#include <gtest/gtest.h>

#include "engine/files/path_exporter.h"
#include "engine/files/scenario_io.h"
#include "engine/planning/path_certificate.h"
#include "tests/engine/files/scenario_fixture.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade::test {

/// A certified path beside the wall of boxScenario(), with a node of each author and numbers that need many digits.
class PathFixture : public testing::Test {
 protected:
  void SetUp() override {
    Result<LoadedScenario> loaded = loadGeometry(boxScenario(), folder_.path(), "boxes.json");
    ASSERT_TRUE(loaded.ok()) << toString(loaded.error());
    scenario_ = *loaded;
    path_.points = {{Pose::translation({-3, 0, 0}), Author::Computer},
                    {{{-1.0 / 3.0, 3.5, 0.1}, fromRollPitchYaw(0.1, -0.2, 3.0)}, Author::Contact},
                    {Pose::translation({1.2, 3.1, 0}), Author::Operator}};
    path_.certificate = certifyPath(*scenario_.problem.world->makeQuery(), path_.points, scenario_.parameters);
  }

  TemporaryFolder folder_;
  LoadedScenario scenario_;
  Path path_;
  PathProvenance provenance_{"birrt", 7};
};

}  // namespace glissade::test
