#include "engine/files/assembly_edits.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/files/part_files.h"
#include "engine/files/scenario_bodies.h"
#include "engine/files/scenario_file.h"
#include "engine/files/scenario_io.h"
#include "tests/engine/files/scenario_fixture.h"
#include "tests/engine/support/loaded_scenario.h"
#include "tests/engine/support/part_fixture.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

const AssemblyItem kStart{AssemblyItem::Kind::Start, {}};
const AssemblyItem kGoal{AssemblyItem::Kind::Goal, {}};

using test::loadedFrom;
using test::worldBox;

void expectRefused(const Outcome& outcome, const std::string& reason) {
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.error().kind, ErrorKind::Usage);
  EXPECT_NE(toString(outcome.error().reason).find(reason), std::string::npos) << toString(outcome.error().reason);
  EXPECT_FALSE(outcome.error().advice.empty());
}

/// Bounding box of a rigid body, or of the object at its start, world frame.
TEST(AssemblyEdits, PutBodiesAndEndsSomewhere) {
  Scenario scenario = test::boxScenario();
  const BodyId id = scenario.bodies.front().id;
  const Pose there = Pose::translation({1, 2, 3});
  for (const AssemblyItem& item : {AssemblyItem{AssemblyItem::Kind::Body, id}, kStart, kGoal}) {
    ASSERT_TRUE(place(item, there, scenario).ok());
    EXPECT_EQ(poseOf(scenario, item), there);
  }
  scenario.goal = GoalOut{};
  EXPECT_FALSE(poseOf(scenario, kGoal));
  expectRefused(swapEnds(scenario), "has no position");
  expectRefused(place({AssemblyItem::Kind::Body, "nobody"}, there, scenario), "no such body");
  expectRefused(place(kStart, Pose::translation({std::nan(""), 0, 0}), scenario), "position in space");
}

TEST(AssemblyEdits, ABodyIsRenamedWithinItsAssembly) {
  Scenario scenario = test::boxScenario();
  scenario.bodies.front().name = "frame/left/block";
  const BodyId id = scenario.bodies.front().id;
  ASSERT_TRUE(renameBody(id, "support", scenario).ok());
  EXPECT_EQ(scenario.bodies.front().name, "frame/left/support");
  for (const char* name : {"", "a/b"}) expectRefused(renameBody(id, name, scenario), "cannot have the name");
  EXPECT_EQ(scenario.bodies.front().name, "frame/left/support");
  EXPECT_FALSE(renameBody("nobody", "x", scenario).ok());
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
  ASSERT_TRUE(markMoving({"tray"}, before, other).ok());
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
  ASSERT_TRUE(markMoving({"block"}, after, back).ok());
  const LoadedScenario again = loadedFrom(back);
  EXPECT_LT((again.problem.start.position - before.problem.start.position).norm(), 1e-9);
  EXPECT_LT((worldBox(again, "tray").min() - worldBox(before, "tray").min()).norm(), 1e-9);
  expectRefused(markMoving({"block"}, again, back), "the object already");
  expectRefused(markMoving({"nobody"}, again, back), "no such body");
}

/// Boxes of 0.1 m in a row, turned against each other; "a" moves.
Scenario rowOfBoxes() {
  Scenario scenario;
  scenario.object.bodies = {{"a", "rack/a", Mobility::Static, BoxGeometry{{0.1, 0.1, 0.1}}}};
  for (const char* id : {"b", "c", "d"}) {
    const double x = 0.2 * static_cast<double>(scenario.bodies.size() + 1);
    scenario.bodies.push_back({BodyId(id), std::string("rack/") + id, Mobility::Static, BoxGeometry{{0.1, 0.1, 0.1}},
                               Pose{Vector3(x, 0.0, 0.0), fromRollPitchYaw(0.0, 0.0, x)}});
  }
  scenario.goal = GoalOut{};
  scenario.workspace = Box3(Vector3::Constant(-2.0), Vector3::Constant(2.0));
  return scenario;
}

/// Bounding box of a body of the product, whether it moves or not.
Box3 boxInProduct(const LoadedScenario& loaded, const std::string& id) {
  for (const RigidBody& body : rigidBodiesOf(loaded)) {
    if (body.id.text() == id) return boundingBox(*body.mesh, body.X_WB);
  }
  ADD_FAILURE() << "no body " << id;
  return {};
}

TEST(AssemblyEdits, AGroupMovesAsOneAndEachOfItsBodiesStaysInTheProduct) {
  const LoadedScenario before = loadedFrom(rowOfBoxes());
  Scenario grouped = before.scenario;
  ASSERT_TRUE(markMoving({"c", "b"}, before, grouped).ok());
  const LoadedScenario group = loadedFrom(grouped);
  EXPECT_EQ(idsOf(group.obstacles), (std::vector<BodyId>{"a", "d"}));
  EXPECT_EQ(idsOf(group.objectBodies), (std::vector<BodyId>{"c", "b"}));
  EXPECT_EQ(group.object.id, "c");
  EXPECT_EQ(group.object.shown(), "c + 1");
  EXPECT_EQ(idOf(grouped.object), "c+b");
  for (const char* id : {"a", "b", "c", "d"}) {
    EXPECT_LT((boxInProduct(group, id).min() - boxInProduct(before, id).min()).norm(), 1e-12) << id;
    EXPECT_LT((boxInProduct(group, id).max() - boxInProduct(before, id).max()).norm(), 1e-12) << id;
  }
  // The object consists of both, about their middle.
  Box3 both = boxInProduct(before, "b");
  both.extend(boxInProduct(before, "c"));
  const Box3 object = boundingBox(*group.object.mesh, group.problem.start);
  EXPECT_LT((object.min() - both.min()).norm() + (object.max() - both.max()).norm(), 1e-12);
  EXPECT_TRUE(isObject({"b", "c"}, grouped));
  expectRefused(markMoving({"b", "c"}, group, grouped), "the object already");

  // First a body that already moves and a new one; then one alone.
  Scenario more = group.scenario;
  ASSERT_TRUE(markMoving({"b", "d"}, group, more).ok());
  const LoadedScenario other = loadedFrom(more);
  Scenario alone = other.scenario;
  ASSERT_TRUE(markMoving({"a"}, other, alone).ok());
  for (const LoadedScenario& loaded : {other, loadedFrom(alone)}) {
    EXPECT_EQ(loaded.obstacles.size() + loaded.objectBodies.size(), 4U);
    for (const char* id : {"a", "b", "c", "d"}) {
      EXPECT_LT((boxInProduct(loaded, id).min() - boxInProduct(before, id).min()).norm(), 1e-12) << id;
    }
  }
}

TEST(AssemblyEdits, WhatIsLeftOutIsKeptAndComesBack) {
  Scenario scenario = rowOfBoxes();
  scenario.fits.pairs = {{"b", "c", {}, 0.0, false}, {"a", "c", {}, 0.0, false}};
  scenario.joints = {{{JointKind::Permanent, "b", {"c"}}, JointEdit::Word::Dissolved},
                     {{JointKind::Screw, "a", {"c"}}, JointEdit::Word::Confirmed, Joint{}, {"b"}}};
  ASSERT_TRUE(leaveOut("b", scenario).ok());
  expectRefused(leaveOut("b", scenario), "no such body");
  expectRefused(leaveOut("a", scenario), "is the moving part");
  EXPECT_EQ(scenario.fits.pairs.size(), 1U) << "nothing is said about what is not there";
  ASSERT_EQ(scenario.joints.size(), 1U);
  EXPECT_TRUE(scenario.joints[0].clamped.empty());
  scenario.joints.clear();
  const auto read = parseScenario(writeScenario(scenario), "file");
  ASSERT_TRUE(read) << toString(read.error());
  const test::TemporaryFolder folder;
  const auto without = loadScenario(folder.write("left.json", writeScenario(*read)));
  ASSERT_TRUE(without) << toString(without.error());
  EXPECT_EQ(without->obstacles.size(), 2U);
  EXPECT_TRUE(std::any_of(without->warnings.begin(), without->warnings.end(), [](const Diagnostic& warning) {
    return toString(warning.reason).find("excludes bodies: 'rack/b'") != std::string::npos;
  })) << "a proof is about what is there";
  Scenario back = *read;
  ASSERT_TRUE(putBack("b", back).ok());
  EXPECT_TRUE(back.leftOut.empty());
  EXPECT_LT((boxInProduct(loadedFrom(back), "b").min() - boxInProduct(loadedFrom(rowOfBoxes()), "b").min()).norm(),
            1e-12);
}

TEST(AssemblyEdits, WhatIsNotOfTheAssemblyStays) {
  Scenario edited = test::boxScenario();
  edited.bodies.clear();
  edited.planner = "birrt";
  edited.seed = 77;
  edited.joints = {{{JointKind::Permanent, "a", {"b"}}, JointEdit::Word::Dissolved}};
  Scenario scenario = test::boxScenario();
  takeAssembly(edited, scenario);
  EXPECT_TRUE(scenario.bodies.empty());
  EXPECT_EQ(scenario.joints, edited.joints) << "they are edited step by step";
  EXPECT_EQ(scenario.planner, test::boxScenario().planner);
  EXPECT_EQ(scenario.seed, test::boxScenario().seed);
}

}  // namespace
}  // namespace glissade
