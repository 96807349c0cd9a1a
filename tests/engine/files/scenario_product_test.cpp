// Tests the tree of a scenario's product: files of earlier versions, names by importers, and attributes of assemblies.
#include "engine/files/scenario_product.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>

#include "engine/files/assembly_edits.h"
#include "engine/files/part_adder.h"
#include "engine/files/part_files.h"
#include "engine/files/product_file.h"
#include "engine/files/scenario_io.h"
#include "engine/files/sequence_knowledge.h"
#include "engine/model/body_path.h"
#include "engine/places/held_edits.h"
#include "tests/engine/files/scenario_fixture.h"
#include "tests/engine/support/loaded_scenario.h"
#include "tests/engine/support/step_files.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using testing::ElementsAre;

/// Boxes beside each other with these names; ids are the names with "." for "/".
Scenario boxesNamed(const std::vector<std::string>& names) {
  Scenario scenario = test::boxScenario();
  scenario.bodies.clear();
  for (const std::string& name : names) {
    BodyDescription body;
    body.name = name;
    std::string id = name;
    std::replace(id.begin(), id.end(), '/', '.');
    body.id = BodyId(id);
    body.geometry = BoxGeometry{{0.1, 0.1, 0.1}};
    body.pose = Pose::translation({0.2 * static_cast<double>(scenario.bodies.size()), 2.0, 0.0});
    scenario.bodies.push_back(body);
  }
  return scenario;
}

std::vector<std::string> assembliesOf(const Product& product) {
  std::vector<std::string> ids;
  for (const Product::Node& node : product.nodes()) {
    if (node.isAssembly) ids.push_back(node.id);
  }
  return ids;
}

const Product::Node& nodeOf(const std::string& id, const Product& product) {
  const auto node = product.find(id);
  EXPECT_TRUE(node) << id;
  return product.nodes()[node.value_or(0)];
}

std::string parentOf(const std::string& id, const Product& product) {
  const auto parent = nodeOf(id, product).parent;
  return parent ? product.nodes()[*parent].id : "";
}

TEST(ScenarioProduct, AFileOfBeforeHasTheAssembliesOfItsNames) {
  const Product product = treeOf(boxesNamed({"rod/nut", "rod/nut#2", "plate", "rod/inner/pin"}));
  EXPECT_THAT(assembliesOf(product), ElementsAre("rod", "rod/inner"));
  EXPECT_THAT(textsOf(product.bodiesBelow(0)), ElementsAre("rod.nut", "rod.nut#2", "rod.inner.pin"));
}

TEST(ScenarioProduct, WhatMovesAndWhatIsLeftOutAreNodesAsWell) {
  Scenario scenario = boxesNamed({"rod/nut", "rod/pin", "rod/ring"});
  scenario.object.bodies = {scenario.bodies[0]};
  scenario.leftOut = {scenario.bodies[1]};
  scenario.bodies.erase(scenario.bodies.begin(), scenario.bodies.begin() + 2);
  const Product product = treeOf(scenario);
  EXPECT_THAT(textsOf(product.bodiesBelow(*product.find("rod"))), ElementsAre("rod.ring", "rod.nut", "rod.pin"));
}

TEST(ScenarioProduct, AnAttributeOfAnAssemblyHoldsForItsBodiesUnlessTheySayOtherwise) {
  Scenario scenario = boxesNamed({"rod/nut", "rod/inner/pin", "plate", "rod/inner/ring"});
  scenario.nodes = {{"rod", std::nullopt, std::nullopt, {{"fragile", true}, {"mass", 2.0}}},
                    {"rod/inner", std::nullopt, std::nullopt, {{"mass", 3.0}}}};
  scenario.bodies[3].attributes = {{"fragile", false}};
  const SemanticEdits held = heldEdits(semanticEditsOf(scenario), treeOf(scenario));
  EXPECT_EQ(held.bodies.at("rod.nut"), (Attributes{{"fragile", true}, {"mass", 2.0}}));
  EXPECT_EQ(held.bodies.at("rod.inner.pin"), (Attributes{{"fragile", true}, {"mass", 3.0}})) << "the nearest counts";
  EXPECT_EQ(held.bodies.at("rod.inner.ring"), (Attributes{{"fragile", false}, {"mass", 3.0}}));
  EXPECT_EQ(held.bodies.size(), 3U) << "neither the plate nor assemblies";
}

TEST(ScenarioProduct, AClassOfAnAssemblyIsThatOfItsBodies) {
  Scenario scenario = boxesNamed({"screws/one", "screws/two", "plate"});
  scenario.nodes = {{"screws", std::nullopt, std::nullopt, {{"class", std::string("socket_head_screw")}}}};
  const LoadedScenario loaded = test::loadedFrom(scenario);
  const auto demands = knownDemands(scenario, productOf(loaded));
  ASSERT_TRUE(demands.ok()) << toString(demands.error());
  ASSERT_EQ(demands->fasteners.size(), 2U);
  EXPECT_EQ(demands->fasteners[1], (std::pair<std::string, std::string>{"screws.two", "screw"}));
}

TEST(ScenarioProduct, MobilityOfAnAssemblyIsThatOfItsBodies) {
  Scenario scenario = boxesNamed({"cart/box", "wall"});
  scenario.nodes = {{"cart", std::nullopt, std::nullopt, {{"mobility", std::string("mobile")}}}};
  const LoadedScenario loaded = test::loadedFrom(scenario);
  EXPECT_EQ(loaded.obstacles[0].mobility, Mobility::Mobile);
  EXPECT_EQ(loaded.obstacles[1].mobility, Mobility::Static);
  EXPECT_EQ(loaded.problem.scene.edits->bodies.count("cart"), 0U) << "planners know bodies only";
  EXPECT_EQ(loaded.problem.scene.edits->bodies.count("cart.box"), 1U);
}

TEST(ScenarioProduct, EditsOfAssembliesAreKeptByTheFile) {
  Scenario scenario = boxesNamed({"rod/nut", "plate"});
  SemanticEdits edits = semanticEditsOf(scenario);
  edits.bodies["rod"] = {{"fragile", true}};
  edits.bodies["rod.nut"] = {{"mass", 1.0}};
  setSemanticEdits(edits, scenario);
  const auto read = parseScenario(writeScenario(scenario), "s.json");
  ASSERT_TRUE(read.ok()) << toString(read.error());
  EXPECT_EQ(semanticEditsOf(*read), edits);
  EXPECT_EQ(read->nodes, scenario.nodes);
  setSemanticEdits({}, scenario);
  EXPECT_TRUE(scenario.nodes.empty()) << "what says nothing any more goes";
}

TEST(ScenarioProduct, WhatWasSaidOfAnAssemblyGoesWithItsLastBody) {
  Scenario scenario = boxesNamed({"rod/nut", "rod/pin", "plate"});
  scenario.nodes = {{"rod", "Rod / 1"}};
  ASSERT_TRUE(removeBody("rod.nut", scenario).ok());
  EXPECT_EQ(scenario.nodes.size(), 1U);
  ASSERT_TRUE(leaveOut("rod.pin", scenario).ok());
  EXPECT_TRUE(parseScenario(writeScenario(scenario), "s.json").ok()) << "what is left out is a node as well";
  ASSERT_TRUE(putBack("rod.pin", scenario).ok());
  ASSERT_TRUE(removeBody("rod.pin", scenario).ok());
  EXPECT_TRUE(scenario.nodes.empty());
}

TEST(ScenarioProduct, BodiesOfOneDescriptionStandBelowIt) {
  const LoadedScenario loaded = [] {
    Scenario scenario = test::boxScenario();
    scenario.assets = {{"unit", test::stepFile("unit.step"), "", 1.0}};
    BodyDescription unit;
    unit.id = "unit";
    unit.name = "unit";
    unit.geometry = StepGeometry{"unit", ""};
    unit.pose = Pose::translation({0.0, 2.0, 0.0});
    scenario.bodies.push_back(unit);
    return test::loadedFrom(scenario);
  }();
  EXPECT_EQ(parentOf("unit/pin#2", loaded.product), "unit");
  EXPECT_EQ(parentOf("unit/pump/housing", loaded.product), "unit/pump");
  EXPECT_EQ(nodeOf("unit/pin#2", loaded.product).names.product, "pin") << "as the file has it";
  EXPECT_FALSE(nodeOf("unit", loaded.product).isAssembly);
}

/// The unit with other names.
class RenamedUnit : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& pump, const std::string& housing) const {
    std::string text = test::replaced(test::stepText("unit.step"), "'pump'", "'" + pump + "'");
    std::ofstream(folder / name) << test::replaced(text, "'housing'", "'" + housing + "'");
    return folder / name;
  }
  static Scenario made(const std::vector<std::string>& files) {
    std::vector<PartFile> parts;
    for (const std::string& each : files) {
      parts.push_back(usualPart(each));
      parts.back().role = parts.size() == 1 ? PartRole::Moves : PartRole::Static;
    }
    auto scenario = scenarioOfParts(parts);
    EXPECT_TRUE(scenario.ok()) << toString(scenario.error());
    return scenario ? *scenario : Scenario();
  }

  test::TemporaryFolder folder;
};

TEST_F(RenamedUnit, NamesWithASlashAreKept) {
  const std::string unit = file("unit.step", "pump/main", "M3/6");
  const Scenario scenario = made({unit + ":plate", unit});
  const Product product = treeOf(scenario);
  EXPECT_EQ(nodeOf("pump_main", product).names.product, "pump/main");
  EXPECT_EQ(nodeOf("pump_main.M3_6", product).names.product, "M3/6");
  EXPECT_EQ(parentOf("pump_main.M3_6", product), "pump_main");
  EXPECT_THAT(textsOf(bodiesMeant(product, "M3/6")), ElementsAre("pump_main.M3_6"));
  EXPECT_EQ(bodiesMeant(product, "pump/main").size(), 2U);
  const auto read = parseScenario(writeScenario(scenario), "s.json");
  ASSERT_TRUE(read.ok()) << toString(read.error());
  EXPECT_EQ(writeScenario(*read), writeScenario(scenario));
  EXPECT_EQ(nodeOf("pump_main", treeOf(*read)).names.product, "pump/main");
  auto loaded = loadProduct(unit);
  ASSERT_TRUE(loaded.ok()) << toString(loaded.error());
  EXPECT_EQ(nodeOf("pump_main/M3_6", loaded->product.tree).names.product, "M3/6");
  ASSERT_TRUE(leaveOut({"pump/main"}, *loaded).ok());
  EXPECT_EQ(loaded->product.bodies.size(), 3U);
}

TEST_F(RenamedUnit, EmptyNamesHaveAStep) {
  const std::string unit = file("unit.step", "", "");
  const auto loaded = loadProduct(unit);
  ASSERT_TRUE(loaded.ok()) << toString(loaded.error());
  for (const Product::Node& node : loaded->product.tree.nodes()) EXPECT_FALSE(lastStepOf(node.path).empty());
  for (const std::string& name : loaded->product.tree.shownNames()) EXPECT_FALSE(name.empty());
  EXPECT_EQ(treeOf(made({unit + ":plate", unit})).nodes().size(), 6U);
}

TEST_F(RenamedUnit, AssembliesOfTwoFilesWithOneNameAreTwo) {
  const std::string one = file("one.step", "pump", "housing");
  const std::string other = file("other.step", "pump", "housing");
  Scenario scenario = made({one + ":plate", one, other + ":pump"});
  const Product product = treeOf(scenario);
  EXPECT_THAT(assembliesOf(product), ElementsAre("pump", "pump#2"));
  EXPECT_EQ(nodeOf("pump#2", product).names.product, "pump");
  EXPECT_EQ(product.bodiesBelow(*product.find("pump")).size(), 2U);
  EXPECT_EQ(product.bodiesBelow(*product.find("pump#2")).size(), 2U);
  EXPECT_EQ(scenario.bodies.back().name.substr(0, 5), "pump/") << "the body's name is its path in its file";
  const auto read = parseScenario(writeScenario(scenario), "s.json");
  ASSERT_TRUE(read.ok()) << toString(read.error());
  EXPECT_THAT(assembliesOf(treeOf(*read)), ElementsAre("pump", "pump#2"));
  const auto more = withParts(scenario, "", {usualPart(other + ":pin")});
  ASSERT_TRUE(more.ok());
  EXPECT_EQ(assembliesOf(treeOf(*more)).size(), 2U);
}

TEST_F(RenamedUnit, OrdinaryNamesAddNothingToTheFile) {
  const std::string unit = test::stepFile("unit.step");
  EXPECT_TRUE(made({unit + ":pin", unit}).nodes.empty());
}

/// Seconds of the processor for making, writing and reading a product of `count` bodies, 41 levels deep.
double secondsFor(int count) {
  std::string above;
  for (int level = 0; level < 40; ++level) above = joinedPath(above, "level" + std::to_string(level));
  Scenario scenario = test::boxScenario();
  scenario.bodies.clear();
  PartAdder adder(scenario, "");
  const std::clock_t begin = std::clock();
  for (int i = 0; i < count; ++i) {
    PartFile part = usualPart(test::stepFile("unit.step"));
    part.part = joinedPath(above, "M3_" + std::to_string(i));
    part.names = productNames(stepsOf(above));
    part.names.push_back({"M3/" + std::to_string(i)});
    adder.addBody(part);
  }
  const auto bodies = static_cast<std::size_t>(count);
  EXPECT_EQ(scenario.nodes.size(), bodies);
  const auto read = parseScenario(writeScenario(scenario), "s.json");
  EXPECT_TRUE(read.ok()) << (read.ok() ? "" : toString(read.error()));
  if (!read) return 0.0;
  const Product product = treeOf(*read);
  EXPECT_EQ(product.nodes().size(), bodies + 41);
  EXPECT_EQ(product.bodiesBelow(0).size(), bodies);
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// Four times as many bodies take four times as long, not sixteen times. Other processes on the machine slow down a
/// part of the measurements, so the least of some is taken.
TEST(ScenarioProduct, TimeGrowsWithTheBodies) {
  double few = secondsFor(2'000);
  double many = secondsFor(8'000);
  for (int again = 0; again < 3 && many >= 10.0 * few; ++again) {
    few = std::min(few, secondsFor(2'000));
    many = std::min(many, secondsFor(8'000));
  }
  EXPECT_LT(many, 10.0 * few);
}

}  // namespace
}  // namespace glissade
