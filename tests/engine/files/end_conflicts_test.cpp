#include "engine/files/end_conflicts.h"

#include <gtest/gtest.h>

#include "engine/files/scenario_io.h"
#include "tests/engine/support/loaded_scenario.h"

namespace glissade {
namespace {

/// A cube of 0.2 m between two blocks.
Scenario betweenBlocks(double x) {
  Scenario scenario;
  scenario.object.first().id = "cube";
  scenario.object.first().name = "cube";
  scenario.object.first().geometry = BoxGeometry{{0.2, 0.2, 0.2}};
  for (const double side : {-1.0, 1.0}) {
    BodyDescription block;
    block.name = side < 0.0 ? "left" : "right";
    block.id = BodyId(block.name);
    block.geometry = BoxGeometry{{0.2, 1.0, 1.0}};
    block.pose.position.x() = side * 0.3;
    scenario.bodies.push_back(block);
  }
  scenario.start.position.x() = x;
  scenario.goal = Pose::translation({0.0, 0.0, 3.0});
  scenario.workspace = Box3(Vector3::Constant(-4.0), Vector3::Constant(4.0));
  return scenario;
}

TEST(EndConflicts, TellTheBodiesAndHowDeepTheyOverlap) {
  const LoadedScenario scenario = test::loadedFrom(betweenBlocks(0.103));
  const auto found = findEndConflicts(scenario, 1e-6);
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->atStart);
  ASSERT_EQ(found->conflicts.size(), 1U);
  EXPECT_EQ(scenario.obstacles[found->conflicts[0].obstacle].id, "right");
  ASSERT_TRUE(found->conflicts[0].overlap.has_value());
  EXPECT_NEAR(*found->conflicts[0].overlap, 0.003, 2e-4);
  ASSERT_FALSE(found->conflicts[0].cut.empty());
  for (const Vector3& p : found->conflicts[0].cut) EXPECT_NEAR(p.x(), 0.2, 1e-9) << "the face of the block";
}

TEST(EndConflicts, TellWhatIsNearerThanRequired) {
  const LoadedScenario scenario = test::loadedFrom(betweenBlocks(0.098));
  EXPECT_FALSE(findEndConflicts(scenario, 1e-3).has_value());
  const auto found = findEndConflicts(scenario, 5e-3);
  ASSERT_TRUE(found.has_value());
  ASSERT_EQ(found->conflicts.size(), 1U);
  EXPECT_FALSE(found->conflicts[0].overlap.has_value());
  EXPECT_NEAR(found->conflicts[0].distance, 0.002, 1e-9);
}

TEST(EndConflicts, LookAtTheGoalWhereTheStartIsFree) {
  Scenario blocked = betweenBlocks(0.0);
  blocked.goal = Pose::translation({-0.15, 0.0, 0.0});
  const auto found = findEndConflicts(test::loadedFrom(blocked), 1e-6);
  ASSERT_TRUE(found.has_value());
  EXPECT_FALSE(found->atStart);
  EXPECT_NEAR(found->q.position.x(), -0.15, 1e-12);
}

TEST(EndConflicts, LeaveOutWhatIsAllowedAsAFit) {
  Scenario fitted = betweenBlocks(0.103);
  fitted.fits.on = true;
  fitted.fits.pairs.push_back({"cube", "right", {}, {}, true});
  const LoadedScenario scenario = test::loadedFrom(fitted);
  EXPECT_EQ(scenario.fits.allowed.size(), 2U) << "each is below a part of a face of the other one";
  EXPECT_FALSE(findEndConflicts(scenario, 1e-6).has_value());
}

}  // namespace
}  // namespace glissade
