// Tests STEP files as parts of a product: one body for each part, named by its path in the file's assembly.
#include "engine/import/step_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/files/assembly_edits.h"
#include "engine/files/part_files.h"
#include "engine/files/product_file.h"
#include "engine/files/scenario_bodies.h"
#include "engine/files/scenario_io.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/primitives.h"
#include "engine/import/part_solids.h"
#include "engine/model/body_path.h"
#include "tests/engine/support/loaded_scenario.h"
#include "tests/engine/support/mapped_step.h"
#include "tests/engine/support/step_files.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::stepFile;
using testing::ElementsAre;
using testing::HasSubstr;

PartFile entry(const std::string& text, PartRole role) {
  PartFile part = usualPart(text);
  part.role = role;
  return part;
}
PartFile moving(const std::string& text) { return entry(text, PartRole::Moves); }
PartFile still(const std::string& text) { return entry(text, PartRole::Static); }
PartFile mobile(const std::string& text) { return entry(text, PartRole::Mobile); }

const std::string kUnit = stepFile("unit.step");

Scenario scenarioOf(const std::vector<PartFile>& parts) {
  auto scenario = scenarioOfParts(parts);
  EXPECT_TRUE(scenario) << toString(scenario.error());
  return scenario ? std::move(*scenario) : Scenario();
}

using test::loadedFrom;
using test::worldBox;

std::vector<std::string> idsOf(const LoadedScenario& loaded) {
  std::vector<std::string> ids;
  for (const RigidBody& body : loaded.obstacles) ids.push_back(body.id.text());
  return ids;
}

TEST(StepParts, OneMovesAndTheRestOfTheFileStaysWhereTheAssemblyHasIt) {
  const LoadedScenario loaded = loadedFrom(scenarioOf({moving(kUnit + ":pin"), still(kUnit)}));
  EXPECT_EQ(loaded.object.id, "pin");
  EXPECT_THAT(idsOf(loaded), ElementsAre("plate", "pin#2", "pump.housing", "pump.Läufer"));
  EXPECT_EQ(loaded.obstacles[3].name, "pump/Läufer");
  EXPECT_TRUE(worldBox(loaded, "pin").center().isApprox(Vector3(0, 0, 0.01), 1e-3));
  EXPECT_TRUE(worldBox(loaded, "pin#2").center().isApprox(Vector3(0, 0.2, 0.008), 1e-3));
  EXPECT_TRUE(worldBox(loaded, "pump.housing").center().isApprox(Vector3(0.3, 0, 0.02), 1e-3));
  EXPECT_NEAR(loaded.problem.world->objectRadius(), Vector3(0.008, 0, 0.02).norm(), 1e-4) << "about its middle";
  EXPECT_NEAR(loaded.obstacles[0].colour[0], 0.8, 1e-3);
  EXPECT_NEAR(loaded.object.colour[2], 0.9, 1e-3);
  EXPECT_EQ(loaded.scenario.assets.size(), 1U);
  EXPECT_EQ(loaded.deflections.size(), 4U) << "the housing is a box";
  EXPECT_GT(loaded.deflections.at("pin"), 0.0);
}

TEST(StepParts, AnAssemblyInTheFileMovesAsOne) {
  const LoadedScenario loaded =
      loadedFrom(scenarioOf({moving(kUnit + ":pump"), still(kUnit), mobile(kUnit + ":pin#2")}));
  EXPECT_EQ(loaded.object.name, "pump");
  EXPECT_EQ(audit(*loaded.object.mesh).surfaces.size(), 2U);
  EXPECT_THAT(idsOf(loaded), ElementsAre("plate", "pin", "pin#2"));
  EXPECT_EQ(loaded.obstacles[2].mobility, Mobility::Mobile);
  EXPECT_EQ(loaded.obstacles[1].mobility, Mobility::Static);
}

const std::string kFrames = stepFile("frames.step");

TEST(StepParts, AProductOfSeveralSolidsIsOnePart) {
  const LoadedScenario loaded = loadedFrom(scenarioOf({moving(kFrames + ":pad"), still(kFrames)}));
  ASSERT_THAT(idsOf(loaded), ElementsAre("frame", "frame#2"));
  EXPECT_EQ(loaded.obstacles[0].mesh, loaded.obstacles[1].mesh) << "instances share their triangles";
  EXPECT_EQ(audit(*loaded.obstacles[0].mesh).surfaces.size(), 2U);
  EXPECT_TRUE(audit(*loaded.obstacles[0].mesh).closed());
}

/// A mesh with an open surface has no inside.
TEST(StepParts, AnOpenSurfaceOfAProductLeavesItsSolidsClosed) {
  const auto product = readProduct(stepFile("ribbed.step"));
  ASSERT_TRUE(product) << toString(product.error());
  ASSERT_EQ(product->product.bodies.size(), 2U);
  const MeshAudit solids = audit(*product->product.bodies[0].mesh);
  EXPECT_EQ(solids.surfaces.size(), 2U);
  EXPECT_TRUE(solids.closed());
  EXPECT_EQ(product->product.bodies[1].shown(), "surfaces");
}

TEST(StepParts, ASolidThatIsNamedOpensItsPart) {
  const LoadedScenario loaded = loadedFrom(scenarioOf({moving(kFrames + ":frame/solid#2"), still(kFrames)}));
  EXPECT_EQ(loaded.object.name, "frame/solid#2");
  EXPECT_THAT(idsOf(loaded), ElementsAre("frame.solid", "frame#2", "pad"));
  const auto open = readProduct(kFrames, {}, 0.0, {{"frame#2"}, {}});
  ASSERT_TRUE(open) << toString(open.error());
  EXPECT_EQ(open->product.bodies.size(), 4U);
  EXPECT_FALSE(readProduct(kFrames, {}, 0.0, {{"pad"}, {}})) << "a part of one solid";
}

/// Scenarios and plans of earlier versions state nothing about parts of several solids: each solid is a body.
TEST(StepParts, EarlierScenariosAndPlansFindTheirSolids) {
  Scenario earlier = scenarioOf({moving(kFrames + ":pad"), still(kFrames)});
  ASSERT_EQ(earlier.bodies.size(), 2U);
  EXPECT_THAT(writeScenario(earlier), HasSubstr("\"as_one\": true"));
  earlier.bodies[0].geometry = StepGeometry{earlier.assets[0].id, "frame"};
  earlier.bodies[1].geometry = StepGeometry{earlier.assets[0].id, "frame#2/solid#2"};
  EXPECT_THAT(writeScenario(earlier), testing::Not(HasSubstr("as_one")));
  EXPECT_THAT(idsOf(loadedFrom(earlier)), ElementsAre("frame/solid", "frame/solid#2", "frame#2"));
  const auto planned = readProduct(kFrames, {}, 0.0, {{}, {"frame/solid", "frame/solid#2", "frame#2", "pad"}});
  ASSERT_TRUE(planned) << toString(planned.error());
  EXPECT_THAT(textsOf(idsOf(planned->product.bodies)), ElementsAre("frame/solid", "frame/solid#2", "frame#2", "pad"));
}

/// Earlier versions named both bodies "stud".
TEST(StepParts, EarlierScenariosAndPlansFindTheBodiesOfMappedProducts) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("mapped.step", test::mappedStepText());
  Scenario earlier = scenarioOf({moving(file + ":pump/housing"), still(file)});
  ASSERT_EQ(earlier.bodies.size(), 4U);
  earlier.bodies = {earlier.bodies[1], earlier.bodies[2]};
  earlier.bodies[0].geometry = StepGeometry{earlier.assets[0].id, "stud"};
  earlier.bodies[1].geometry = StepGeometry{earlier.assets[0].id, "stud#2"};
  const LoadedScenario loaded = loadedFrom(earlier);
  EXPECT_TRUE(worldBox(loaded, "pin").center().isApprox(Vector3(0, 0, 0.01), 1e-3));
  EXPECT_TRUE(worldBox(loaded, "stud#2").center().isApprox(Vector3(0, 0.2, 0.008), 1e-3));
  const auto planned = readProduct(file, {}, 0.0, {{}, {"plate", "stud", "stud#2"}});
  ASSERT_TRUE(planned) << toString(planned.error());
  EXPECT_TRUE(planned->product.find("stud#2"));
}

TEST(StepParts, AFileOfOnePartIsTakenAsItsSolids) {
  const auto whole = loadProduct(stepFile("two-solids.step"));
  ASSERT_TRUE(whole) << toString(whole.error());
  EXPECT_EQ(whole->product.bodies.size(), 2U);
  ASSERT_EQ(whole->warnings.size(), 1U);
  EXPECT_THAT(toString(whole->warnings[0].reason), HasSubstr("one part of 2 solids"));
}

/// The window lists the parts of a file before they are taken.
TEST(StepParts, AFileOfOnePartIsListedAsItsSolids) {
  GeometryCache read;
  const std::string file = stepFile("two-solids.step");
  const auto listed = partsInFile(file, read);
  ASSERT_TRUE(listed) << toString(listed.error());
  ASSERT_EQ(listed->size(), 2U);
  PartFile first = moving(file + ":" + listed->front().part);
  const auto scenario = scenarioOfParts({first, still(file + ":" + listed->back().part)}, &read);
  ASSERT_TRUE(scenario) << toString(scenario.error());
  EXPECT_EQ(presentBodiesOf(*scenario).size(), 2U);
}

TEST(StepParts, AFileOfOnePartIsTakenAsAMesh) {
  const LoadedScenario loaded = loadedFrom(scenarioOf({moving(stepFile("box.step")), still(stepFile("cylinder.STP"))}));
  EXPECT_EQ(loaded.object.id, "box");
  EXPECT_THAT(idsOf(loaded), ElementsAre("cylinder"));
  const LoadedScenario whole = loadedFrom(scenarioOf({moving(kUnit), still(stepFile("box.step"))}));
  EXPECT_EQ(audit(*whole.object.mesh).surfaces.size(), 5U) << "the whole file moves as one";
}

TEST(StepParts, OfAProductWhatWasLostInReadingIsAWarning) {
  const test::TemporaryFolder folder;
  std::string text = test::stepText("fits.step");
  EXPECT_THAT(readProduct(folder.write("whole.step", text))->warnings, testing::IsEmpty());
  const std::string plane = " PLANE(";
  text.replace(text.find(plane), plane.size(), " UNKNOWN_SURFACE(");
  const auto product = readProduct(folder.write("lossy.step", text));
  ASSERT_TRUE(product) << toString(product.error());
  std::string told;
  for (const Diagnostic& warning : product->warnings) told += toString(warning.reason) + "\n";
  EXPECT_THAT(told, testing::HasSubstr("could not be made"));
  EXPECT_THAT(told, testing::HasSubstr("faces or boundaries that could not be made: 1"));
}

TEST(StepParts, SavedAndReadAgainItIsTheSame) {
  const test::TemporaryFolder folder;
  folder.write("unit.step", test::stepText("unit.step"));
  const std::string file = folder / "scenario.json";
  PartFile coarse = still(folder / "unit.step:plate");
  coarse.deflection = 1e-3;
  const Scenario scenario = scenarioOf({moving(folder / "unit.step:pin"), still(folder / "unit.step"), coarse});
  const LoadedScenario before = loadedFrom(scenario);
  ASSERT_TRUE(saveScenario(scenario, file));
  const auto after = loadScenario(file);
  ASSERT_TRUE(after) << toString(after.error());
  EXPECT_EQ(writeScenario(after->scenario), test::readWhole(file));
  EXPECT_EQ(idsOf(*after), idsOf(before));
  for (const std::string& id : idsOf(before)) EXPECT_TRUE(worldBox(*after, id).isApprox(worldBox(before, id), 0.0));
  EXPECT_EQ(after->problem.start, before.problem.start);
  EXPECT_EQ(after->deflections, before.deflections);
}

TEST(StepParts, AWholeFileInAScenarioIsABodyAPart) {
  Scenario scenario = scenarioOf({moving(stepFile("box.step")), still(stepFile("inch.step"))});
  scenario.assets[1].path = kUnit;
  const LoadedScenario loaded = loadedFrom(scenario);
  EXPECT_THAT(idsOf(loaded),
              ElementsAre("inch/plate", "inch/pin", "inch/pin#2", "inch/pump/housing", "inch/pump/Läufer"));
  EXPECT_EQ(bodyIdOf(loaded.obstacles[4].id), "inch");
}

TEST(StepParts, AnyPartCanBeMadeTheOneThatMovesAndBack) {
  const LoadedScenario first = loadedFrom(scenarioOf({moving(kUnit + ":pin"), still(kUnit)}));
  Scenario scenario = first.scenario;
  ASSERT_TRUE(markMoving({"pump.Läufer"}, first, scenario));
  const LoadedScenario second = loadedFrom(scenario);
  EXPECT_EQ(second.object.id, "pump.Läufer");
  for (const char* id : {"pin", "plate", "pump.Läufer"}) {
    EXPECT_TRUE(worldBox(second, id).isApprox(worldBox(first, id), 1e-12)) << id;
  }
  EXPECT_NEAR(second.problem.world->objectRadius(), Vector3(0.005, 0, 0.015).norm(), 1e-4);
  ASSERT_TRUE(removeBody("pin#2", scenario));
  EXPECT_EQ(loadedFrom(scenario).obstacles.size(), 3U);
}

TEST(StepParts, AddedLaterAFileBringsWhatIsNotThereYet) {
  const Scenario scenario = scenarioOf({moving(kUnit + ":pin"), still(kUnit + ":plate")});
  const auto more = withParts(scenario, "", {mobile(kUnit)});
  ASSERT_TRUE(more) << toString(more.error());
  EXPECT_THAT(idsOf(loadedFrom(*more)), ElementsAre("plate", "pin#2", "pump.housing", "pump.Läufer"));
  const auto nothing = withParts(*more, "", {still(kUnit)});
  ASSERT_FALSE(nothing.ok());
  EXPECT_EQ(nothing.error().kind, ErrorKind::Usage);
  const auto twice = withParts(*more, "", {still(kUnit + ":plate")});
  ASSERT_TRUE(twice) << toString(twice.error());
  EXPECT_EQ(twice->bodies.back().id, "plate-2");
}

TEST(StepParts, ANameThatIsNotThereListsThoseThatAre) {
  const auto refused = scenarioOfParts({moving(kUnit + ":pim"), still(kUnit)});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().kind, ErrorKind::MalformedInput);
  EXPECT_THAT(toString(refused.error().location), HasSubstr("pim"));
  EXPECT_THAT(toString(refused.error().advice), HasSubstr("plate, pin, pin#2, pump/housing, pump/Läufer"));
  Scenario scenario = scenarioOf({moving(kUnit + ":pin"), still(kUnit)});
  scenario.bodies[0].geometry = StepGeometry{"unit", "lid"};
  const auto loaded = loadGeometry(scenario, ".", "s.json");
  ASSERT_FALSE(loaded.ok());
  EXPECT_THAT(loaded.error().file, HasSubstr("unit.step"));
  EXPECT_THAT(toString(loaded.error().advice), HasSubstr("pin#2"));
  EXPECT_THAT(toString(scenarioOfParts({moving(stepFile("box.step:lid"))}).error()), HasSubstr("leave out"));
}

TEST(StepParts, LastNamesDoWhereTheyAreOne) {
  const Product tree({{"1", {"a/pin"}}, {"2", {"a/nut"}}, {"3", {"b/pin"}}, {"4", {"b/c/ring"}}});
  EXPECT_EQ(nodeNamed("a/pin", tree, "f").value(), "a/pin");
  EXPECT_EQ(nodeNamed("b", tree, "f").value(), "b");
  EXPECT_EQ(nodeNamed("c", tree, "f").value(), "b/c");
  EXPECT_EQ(nodeNamed("nut", tree, "f").value(), "a/nut");
  EXPECT_THAT(toString(nodeNamed("pin", tree, "f").error()), HasSubstr("a/pin, b/pin"));
  EXPECT_TRUE(isWithin("b/c/ring", "b/c") && isWithin("b/c/ring", "") && !isWithin("bc/ring", "b"));
  EXPECT_EQ(pathWithin("b/c/ring", "b"), "c/ring");
}

TEST(StepParts, PartsAreNamedBehindTheirFile) {
  EXPECT_EQ(usualPart("a/b.STEP:pump/rotor").path, "a/b.STEP");
  EXPECT_EQ(usualPart("a/b.STEP:pump/rotor").part, "pump/rotor");
  EXPECT_EQ(usualPart("c:d.stp:x:y").path, "c:d.stp");
  EXPECT_EQ(usualPart("c:d.stp:x:y").part, "x:y");
  EXPECT_EQ(usualPart("a.stl:x").path, "a.stl:x");
  const test::TemporaryFolder folder;
  EXPECT_EQ(usualPart(folder.write("a.stp:b.stp", "")).part, "") << "a file that is called so";
}

TEST(StepParts, AStepFileHasAUnitOfItsOwn) {
  PartFile part = moving(stepFile("box.step"));
  part.unit = 0.001;
  EXPECT_THAT(toString(scenarioOfParts({part}).error()), HasSubstr("says itself"));
}

TEST(StepParts, ReadingIsStopped) {
  StopSource stop;
  stop.requestStop();
  const auto stopped = scenarioOfParts({moving(kUnit)}, nullptr, stop.token());
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().kind, ErrorKind::Interrupted);
}

TEST(StepParts, WhatWasReadIsNotReadAgain) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("unit.step", test::stepText("unit.step"));
  GeometryCache read;
  ASSERT_TRUE(partsInFile(file, read));
  folder.write("unit.step", "gone");
  const auto scenario = scenarioOfParts({moving(file + ":pin"), still(file)}, &read);
  ASSERT_TRUE(scenario) << toString(scenario.error());
  EXPECT_TRUE(loadGeometry(*scenario, ".", "", read).ok());
}

/// A part of two closed boxes and one box without its last face.
std::vector<Occurrence> solidsAndASurface() {
  TriangleMesh open = makeBox(Vector3::Ones());
  open.triangles.resize(open.triangles.size() - 2);
  const auto box = std::make_shared<const TriangleMesh>(makeBox(Vector3::Ones()));
  std::vector<Occurrence> shapes;
  for (const auto& [name, mesh] : {std::pair("red", box), std::pair("blue", box),
                                   std::pair("skin", std::make_shared<const TriangleMesh>(std::move(open)))}) {
    Occurrence& shape = shapes.emplace_back();
    shape.path = joinedPath("unit", name);
    shape.mesh = mesh;
    shape.X_FP = Pose::translation({2.0 * static_cast<double>(shapes.size()), 0.0, 0.0});
    shape.isSolidOfPart = true;
  }
  return shapes;
}

std::vector<std::string> pathsOf(const std::vector<Occurrence>& shapes) {
  std::vector<std::string> paths;
  for (const Occurrence& shape : shapes) paths.push_back(shape.path);
  return paths;
}

/// A plan names the bodies that `info` lists. The part must not be opened for the judge because of these names.
TEST(StepParts, SolidsBesideASurfaceAreOneBodyForThePlanAndForTheJudge) {
  const std::vector<Occurrence> solids = solidsAndASurface();
  const auto made = chosenParts(solids, "file", {});
  ASSERT_TRUE(made.ok());
  EXPECT_THAT(pathsOf(*made), ElementsAre("unit/unit", "unit/skin"));
  const std::vector<std::string> ids = pathsOf(*made);
  const auto judged = chosenParts(solids, "file", {{}, {ids.begin(), ids.end()}});
  ASSERT_TRUE(judged.ok());
  EXPECT_EQ(pathsOf(*judged), pathsOf(*made));
  const auto opened = chosenParts(solids, "file", {{}, {"unit/red", "unit/blue", "unit/skin"}});
  ASSERT_TRUE(opened.ok());
  EXPECT_EQ(pathsOf(*opened), pathsOf(solids)) << "a plan of the solids";
}

TEST(StepParts, TheNameOfTheJoinedSolidsIsFree) {
  std::vector<Occurrence> solids = solidsAndASurface();
  solids[2].path = "unit/unit";
  const auto made = chosenParts(solids, "file", {});
  ASSERT_TRUE(made.ok());
  EXPECT_THAT(pathsOf(*made), ElementsAre("unit/unit#2", "unit/unit"));
}

}  // namespace
}  // namespace glissade
