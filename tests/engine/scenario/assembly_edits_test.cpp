#include "engine/scenario/assembly_edits.h"

#include <gtest/gtest.h>

#include "engine/scenario/part_files.h"
#include "engine/scenario/scenario_io.h"
#include "tests/engine/scenario/scenario_fixture.h"
#include "tests/engine/support/loaded_scenario.h"
#include "tests/engine/support/part_fixture.h"

namespace glissade {
namespace {

const AssemblyItem kStart{AssemblyItem::Kind::Start, {}};
const AssemblyItem kGoal{AssemblyItem::Kind::Goal, {}};

using test::loadedFrom;
using test::worldBox;

void expectRefused(const Outcome& outcome, const std::string& reason) {
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.error().kind, ErrorKind::Usage);
  EXPECT_NE(outcome.error().reason.find(reason), std::string::npos) << outcome.error().reason;
  EXPECT_FALSE(outcome.error().advice.empty());
}

/// The box about a rigid body, or the object at its start, in the world.
TEST(AssemblyEdits, PutBodiesAndEndsSomewhere) {
  Scenario scenario = test::boxScenario();
  const std::string id = scenario.bodies.front().id;
  const Pose there = Pose::translation({1, 2, 3});
  for (const AssemblyItem& item : {AssemblyItem{AssemblyItem::Kind::Body, id}, kStart, kGoal}) {
    ASSERT_TRUE(place(item, there, scenario).ok());
    EXPECT_EQ(poseOf(scenario, item), there);
  }
  scenario.goal = GoalOut{};
  EXPECT_FALSE(poseOf(scenario, kGoal));
  expectRefused(swapEnds(scenario), "out");
  expectRefused(place({AssemblyItem::Kind::Body, "nobody"}, there, scenario), "no such body");
  expectRefused(place(kStart, Pose::translation({std::nan(""), 0, 0}), scenario), "position in space");
}

TEST(AssemblyEdits, SwappedTwiceIsTheSame) {
  Scenario scenario = test::boxScenario();
  const std::string before = writeScenario(scenario);
  ASSERT_TRUE(swapEnds(scenario).ok());
  EXPECT_NE(writeScenario(scenario), before);
  ASSERT_TRUE(swapEnds(scenario).ok());
  EXPECT_EQ(writeScenario(scenario), before);
}

TEST(AssemblyEdits, ABodyGoesWithTheAssetThatOnlyItUses) {
  const test::TrayProduct product;
  auto scenario = scenarioOfParts({{product.tray}, {product.block, PartRole::Moves}});
  ASSERT_TRUE(scenario.ok());
  auto more = withParts(*scenario, "", {{product.block}});
  ASSERT_TRUE(more.ok());
  ASSERT_EQ(more->bodies.size(), 2U);
  ASSERT_EQ(more->assets.size(), 2U);
  ASSERT_TRUE(removeBody(more->bodies[1].id, *more).ok());
  EXPECT_EQ(more->assets.size(), 2U) << "the object is made of it, too";
  ASSERT_TRUE(removeBody(more->bodies[0].id, *more).ok());
  EXPECT_EQ(more->assets.size(), 1U);
  expectRefused(removeBody("tray", *more), "no such body");
}

TEST(AssemblyEdits, AnotherPartMovesAndNothingGoesElsewhere) {
  const test::TrayProduct product;
  auto scenario = scenarioOfParts({{product.tray}, {product.block, PartRole::Moves}});
  ASSERT_TRUE(scenario.ok());
  const Pose turned{Vector3(0.1, 0.2, 0.0), fromRollPitchYaw(0.0, 0.0, 0.5)};
  ASSERT_TRUE(place({AssemblyItem::Kind::Body, "tray"}, turned, *scenario).ok());
  const LoadedScenario before = loadedFrom(*scenario);

  Scenario other = before.scenario;
  ASSERT_TRUE(markMoving("tray", before, other).ok());
  const LoadedScenario after = loadedFrom(other);
  EXPECT_EQ(after.object.id, "tray");
  ASSERT_EQ(after.obstacles.size(), 1U);
  EXPECT_EQ(after.obstacles.front().id, "block");
  for (const char* id : {"tray", "block"}) {
    EXPECT_LT((worldBox(after, id).min() - worldBox(before, id).min()).norm(), 1e-9) << id;
    EXPECT_LT((worldBox(after, id).max() - worldBox(before, id).max()).norm(), 1e-9) << id;
  }
  EXPECT_TRUE(std::holds_alternative<GoalOut>(other.goal));
  EXPECT_TRUE(other.workspace.contains(fittingWorkspace(after)));

  Scenario back = after.scenario;
  ASSERT_TRUE(markMoving("block", after, back).ok());
  const LoadedScenario again = loadedFrom(back);
  EXPECT_LT((again.problem.start.position - before.problem.start.position).norm(), 1e-9);
  EXPECT_LT((worldBox(again, "tray").min() - worldBox(before, "tray").min()).norm(), 1e-9);
  expectRefused(markMoving("block", again, back), "no such body");
}

TEST(AssemblyEdits, WhatIsNotOfTheAssemblyStays) {
  Scenario edited = test::boxScenario();
  edited.bodies.clear();
  edited.planner = "birrt";
  edited.seed = 77;
  Scenario scenario = test::boxScenario();
  takeAssembly(edited, scenario);
  EXPECT_TRUE(scenario.bodies.empty());
  EXPECT_EQ(scenario.planner, test::boxScenario().planner);
  EXPECT_EQ(scenario.seed, test::boxScenario().seed);
}

}  // namespace
}  // namespace glissade
