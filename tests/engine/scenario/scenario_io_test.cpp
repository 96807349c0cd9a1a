#include "engine/scenario/scenario_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>

#include "engine/base/file.h"
#include "tests/engine/scenario/scenario_fixture.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::boxScenario;
using test::fullScenario;
using test::TemporaryFolder;

TEST(ScenarioFile, WriteThenReadThenWriteIsByteIdentical) {
  for (const Scenario& scenario : {boxScenario(), fullScenario()}) {
    const std::string text = writeScenario(scenario);
    const Result<Scenario> read = parseScenario(text, "test.json");
    ASSERT_TRUE(read.ok()) << toString(read.error());
    EXPECT_EQ(writeScenario(*read), text);
  }
}

TEST(ScenarioFile, KeepsEveryValue) {
  const Scenario written = fullScenario();
  const Result<Scenario> read = parseScenario(writeScenario(written), "test.json");
  ASSERT_TRUE(read.ok()) << toString(read.error());
  EXPECT_EQ(read->description, written.description);
  ASSERT_EQ(read->assets.size(), 3U);
  EXPECT_EQ(read->assets[0].unit, 0.001);
  EXPECT_EQ(read->assets[0].up, UpAxis::Y);
  EXPECT_EQ(read->assets[0].deflection, 0.0);
  EXPECT_EQ(read->assets[2].deflection, 1.0 / 3e4);
  ASSERT_EQ(read->bodies.size(), 6U);
  EXPECT_EQ(read->bodies[1].pose, written.bodies[1].pose);  // bit by bit
  EXPECT_EQ(read->bodies[1].mobility, Mobility::Mobile);
  EXPECT_EQ(read->bodies[1].attributes, written.bodies[1].attributes);
  EXPECT_EQ(read->bodies[1].colour, written.bodies[1].colour);
  EXPECT_EQ(std::get<StepGeometry>(read->bodies[3].geometry).part, "pump/rotor");
  EXPECT_EQ(std::get<StepGeometry>(read->bodies[4].geometry).part, "");
  EXPECT_EQ(std::get<CylinderGeometry>(read->bodies[5].geometry).length, 2.0);
  EXPECT_EQ(read->object.referencePoint, written.object.referencePoint);
  EXPECT_TRUE(std::holds_alternative<GoalOut>(read->goal));
  EXPECT_EQ(read->wayPoints, written.wayPoints);
  EXPECT_EQ(read->parameters, written.parameters);
  EXPECT_EQ(read->seed, written.seed);
}

TEST(ScenarioFile, SamplesAreCanonical) {
  for (const char* name : {"environment-1", "environment-2", "sliding-plane"}) {
    const std::string text = test::readWhole(test::sample(name));
    const Result<Scenario> read = parseScenario(text, name);
    ASSERT_TRUE(read.ok()) << toString(read.error());
    EXPECT_EQ(writeScenario(*read), text);
  }
}

TEST(ScenarioFile, VersionOneLoadsWithDefaults) {
  const Result<Scenario> read = parseScenario(R"({"format": "glissade-scenario", "version": 1,
    "object": {"id": "ball", "geometry": {"sphere": {"radius": 1}}},
    "start": {"position": [0, 0, 0], "orientation": [0, 0, 0, 1]}, "goal": "out",
    "bodies": [], "workspace": {"min": [-1, -1, -1], "max": [1, 1, 1]}})",
                                              "v1.json");
  ASSERT_TRUE(read.ok()) << toString(read.error());
  EXPECT_EQ(read->planner, "contact-birrt");
  EXPECT_EQ(read->seed, 1U);
  EXPECT_TRUE(read->bodies.empty());
}

TEST(ScenarioFile, DoesNotDependOnTheLocale) {
  if (std::setlocale(LC_ALL, "fr_FR.UTF-8") == nullptr) GTEST_SKIP() << "the locale fr_FR.UTF-8 is not installed";
  const std::string text = writeScenario(fullScenario());
  const Result<Scenario> read = parseScenario(text, "test.json");
  std::setlocale(LC_ALL, "C");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(writeScenario(fullScenario()), text);
  EXPECT_EQ(read->assets[0].unit, 0.001);
}

TEST(SaveScenario, RecordsTheContentOfItsAssets) {
  const TemporaryFolder folder;
  folder.write("meshes/part.stl", "one");
  folder.write("robot.urdf", "two");
  folder.write("product.step", "three");
  const std::string file = folder / "scenario.json";
  const Outcome saved = saveScenario(fullScenario(), file);
  ASSERT_TRUE(saved.ok()) << toString(saved.error());
  const Result<Scenario> read = parseScenario(test::readWhole(file), file);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->assets[0].sha256, sha256("one"));
  EXPECT_EQ(read->assets[1].sha256, sha256("two"));
}

TEST(SaveScenario, RefusesWhatCouldNotBeLoadedAndKeepsTheOldFile) {
  const TemporaryFolder folder;
  const std::string file = folder.write("scenario.json", "old");
  Scenario broken = boxScenario();
  broken.start.position.x() = std::nan("");
  const Outcome saved = saveScenario(broken, file);
  ASSERT_FALSE(saved.ok());
  EXPECT_THAT(saved.error().place, testing::HasSubstr("/start/position/0"));
  EXPECT_FALSE(saveScenario(fullScenario(), file).ok());  // its assets are not there
  EXPECT_EQ(test::readWhole(file), "old");
}

}  // namespace
}  // namespace glissade
