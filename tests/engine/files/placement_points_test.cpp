#include "engine/files/placement_points.h"

#include <gtest/gtest.h>

#include "engine/files/part_files.h"
#include "engine/files/scenario_io.h"
#include "tests/engine/support/part_fixture.h"
#include "tests/engine/support/step_files.h"

namespace glissade {
namespace {

using Kind = AssemblyItem::Kind;

LoadedScenario loaded(const std::vector<PartFile>& parts) {
  auto scenario = scenarioOfParts(parts);
  EXPECT_TRUE(scenario) << toString(scenario.error());
  auto result = loadGeometry(std::move(*scenario), ".", "");
  EXPECT_TRUE(result) << toString(result.error());
  return std::move(*result);
}

PartFile moving(PartFile part) {
  part.role = PartRole::Moves;
  return part;
}

/// Parts lie where their files have them: the origin of the file is the world's.
TEST(PlacementPoints, TheOriginOfTheFileIsWhereTheFilesCoordinatesAreZero) {
  const test::TrayProduct product;
  const std::string step = test::stepFile("unit.step");
  for (const PartFile& part : {usualPart(product.block), usualPart(step + ":pin#2")}) {
    const LoadedScenario scenario = loaded({moving(part), usualPart(product.tray)});
    const PlacementPoints start = placementPoints(scenario, {Kind::Start, ""});
    EXPECT_LT((scenario.problem.start * start.fileOrigin).norm(), 1e-12);
    const Box3 box = boundingBox(*scenario.object.mesh, scenario.problem.start);
    EXPECT_TRUE((scenario.problem.start * start.middle).isApprox(box.center(), 1e-9));
  }
}

TEST(PlacementPoints, ABodyIsPlacedByItsFile) {
  const test::TrayProduct product;
  LoadedScenario scenario = loaded({moving(usualPart(product.block)), usualPart(product.tray)});
  const AssemblyItem tray{Kind::Body, scenario.scenario.bodies.at(0).id};
  const PlacementPoints points = placementPoints(scenario, tray);
  EXPECT_EQ(points.fileOrigin, Vector3(0, 0, 0));
  EXPECT_TRUE(points.middle.isApprox(boundingBox(*scenario.obstacles.at(0).mesh).center(), 1e-12));
}

}  // namespace
}  // namespace glissade
