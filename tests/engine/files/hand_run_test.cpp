#include "engine/files/hand_run.h"

#include <gtest/gtest.h>

#include "engine/files/product_file.h"
#include "tests/engine/support/loaded_scenario.h"

namespace glissade {
namespace {

BodyDescription box(const BodyId& id, double x) {
  return {id, id.text(), Mobility::Static, BoxGeometry{{0.1, 0.1, 0.1}}, Pose::translation({x, 0.0, 0.0}), {}, {}};
}

Scenario threeBoxes() {
  Scenario scenario;
  scenario.bodies = {box("base", 0.0), box("left", -0.3), box("right", 0.3)};
  scenario.object.bodies = {box("object", 0.0)};
  scenario.start = Pose::translation({0.0, 0.0, 0.3});
  scenario.goal = Pose::translation({0.0, 0.0, 0.6});
  scenario.workspace = Box3(Vector3::Constant(-2.0), Vector3::Constant(2.0));
  return scenario;
}

TEST(HandRun, HasThePartInTheHandAndWhatIsThereAtItsStep) {
  const LoadedScenario loaded = test::loadedFrom(threeBoxes());
  Scenario scenario = loaded.scenario;
  ASSERT_TRUE(prepareHandRun({"right"}, {"left", "object"}, loaded, {}, scenario).ok());
  const LoadedScenario run = test::loadedFrom(scenario);
  EXPECT_EQ(run.object.id, "right");
  ASSERT_EQ(run.obstacles.size(), 1U);
  EXPECT_EQ(run.obstacles.front().id, "base");
  EXPECT_TRUE(std::holds_alternative<GoalOut>(scenario.goal));
  EXPECT_NEAR(run.problem.start.position.x(), 0.3, 1e-12);

  // The object turns about the middle of its box, wherever the scenario has its reference point.
  Scenario beside = loaded.scenario;
  beside.object.referencePoint = {0.05, 0.05, 0.0};
  const LoadedScenario turned = test::loadedFrom(beside);
  ASSERT_TRUE(prepareHandRun({"object"}, {}, turned, {}, beside).ok());
  EXPECT_LT((test::loadedFrom(beside).problem.start.position - Vector3(-0.05, -0.05, 0.3)).norm(), 1e-12);
  EXPECT_LT((test::worldBox(test::loadedFrom(beside), "object").min() - test::worldBox(turned, "object").min()).norm(),
            1e-12);

  Scenario own = loaded.scenario;
  ASSERT_TRUE(prepareHandRun({"object"}, {"left"}, loaded, {}, own).ok());
  EXPECT_EQ(own.object.first().id, "object");
  EXPECT_EQ(own.bodies.size(), 2U);
  EXPECT_TRUE(std::holds_alternative<GoalOut>(own.goal));
}

TEST(HandRun, ThreadsOfTheStepsJointsAreMarkedWhereNobodySaysAnything) {
  const LoadedScenario loaded = test::loadedFrom(threeBoxes());
  StepJoint joint{JointKind::Nut, "right", {"base", "left", "object"}};
  joint.pitch = 1.25e-3;
  joint.turns = 6.0;
  Scenario scenario = loaded.scenario;
  scenario.fits.pairs.push_back({"object", "right", ContactKind::Cylindrical, std::nullopt, false});
  ASSERT_TRUE(prepareHandRun({"right"}, {"left"}, loaded, {joint}, scenario).ok());
  ASSERT_EQ(scenario.fits.pairs.size(), 2U) << "left is gone";
  EXPECT_EQ(scenario.fits.pairs[0].kind, ContactKind::Cylindrical) << "a person's word stays";
  EXPECT_EQ(scenario.fits.pairs[1].b, "base");
  EXPECT_EQ(scenario.fits.pairs[1].kind, ContactKind::Thread);
  EXPECT_EQ(scenario.fits.pairs[1].pitch, 1.25e-3);
  EXPECT_EQ(scenario.fits.pairs[1].turned, "right");

  // For a shaft in a nut, the nut is held, and the shaft's other pairs are unchanged.
  StepJoint shaft{JointKind::Screw, "base", {"right", "left"}};
  shaft.pitch = 1.25e-3;
  shaft.turns = 6.0;
  Scenario held = loaded.scenario;
  ASSERT_TRUE(prepareHandRun({"right"}, {}, loaded, {shaft}, held).ok());
  ASSERT_EQ(held.fits.pairs.size(), 1U);
  EXPECT_EQ(held.fits.pairs[0].a, "base");
  EXPECT_EQ(held.fits.pairs[0].turned, "right");
}

TEST(HandRun, HasAGroupInTheHandAboutItsMiddle) {
  const LoadedScenario loaded = test::loadedFrom(threeBoxes());
  Scenario scenario = loaded.scenario;
  ASSERT_TRUE(prepareHandRun({"left", "base"}, {"object"}, loaded, {}, scenario).ok());
  const LoadedScenario run = test::loadedFrom(scenario);
  ASSERT_EQ(run.objectBodies.size(), 2U);
  ASSERT_EQ(run.obstacles.size(), 1U);
  EXPECT_EQ(run.obstacles.front().id, "right");
  EXPECT_LT((run.problem.start.position - Vector3(-0.15, 0.0, 0.0)).norm(), 1e-12);

  // The path of the group is that of the frame at the middle of its box, with the world's orientation.
  const Pose moved = Pose::translation({0.0, 0.4, 0.1}) * run.problem.start;
  const DemandedMotion motion =
      motionOfRun(run.objectBodies, {{run.problem.start, Author::Computer}, {moved, Author::Operator}}, {"auto"});
  EXPECT_EQ(motion.bodies, (std::vector<std::string>{"left", "base"}));
  EXPECT_LT((motion.path.front().q.position - Vector3(-0.15, 0.0, 0.0)).norm(), 1e-12);
  EXPECT_LT((motion.path.back().q.position - Vector3(-0.15, 0.4, 0.1)).norm(), 1e-12);
}

TEST(HandRun, RefusesAPartOfABodyOfSeveral) {
  LoadedScenario loaded = test::loadedFrom(threeBoxes());
  loaded.obstacles[0].id = "robot/arm";
  loaded.obstacles[1].id = "robot/hand";
  Scenario scenario = loaded.scenario;
  for (const auto& outcome : {prepareHandRun({"robot/arm"}, {}, loaded, {}, scenario),
                              prepareHandRun({"right"}, {"robot/hand"}, loaded, {}, scenario)}) {
    ASSERT_FALSE(outcome.ok());
    EXPECT_EQ(toString(outcome.error().location), "body 'robot'");
    EXPECT_FALSE(outcome.error().advice.empty());
  }
}

TEST(HandRun, ThePathOfTheObjectIsTheMotionOfTheBody) {
  RigidBody body;
  body.id = "right";
  body.X_WB = {{0.3, 0.0, 0.0}, fromRollPitchYaw(0.0, 0.0, 1.0)};
  // The object's frame lies elsewhere in the same rigid body.
  const Pose X_BO{{0.02, 0.0, 0.01}, fromRollPitchYaw(0.3, 0.0, 0.0)};
  const Pose there{{0.3, 0.5, 0.0}, fromRollPitchYaw(0.0, 0.4, 1.0)};
  const DemandedMotion motion =
      motionOfRun({body}, {{body.X_WB * X_BO, Author::Computer}, {there * X_BO, Author::Operator}}, {"contact-birrt"});
  EXPECT_EQ(motion.bodies, std::vector<std::string>{"right"});
  EXPECT_EQ(motion.method, kByHand);
  EXPECT_EQ(motion.path.front().q, body.X_WB);
  EXPECT_LT((motion.path.back().q.position - there.position).norm(), 1e-12);
  EXPECT_LT(motion.path.back().q.orientation.angularDistance(there.orientation), 1e-7);
  EXPECT_EQ(motion.path.back().author, Author::Operator);
  const std::vector<PathPoint> alone{{body.X_WB, Author::Computer}, {there, Author::Computer}};
  EXPECT_EQ(motionOfRun({body}, alone, {"auto"}).method, "auto") << "no hand has moved it";
  EXPECT_EQ(motionOfRun({body}, alone, {"interactive", 1, true}).method, kByHand) << "smoothed since";
}

}  // namespace
}  // namespace glissade
