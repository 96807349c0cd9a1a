#include "engine/files/scenario_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>

#include "engine/base/file.h"
#include "engine/base/file_versions.h"
#include "engine/files/scenario_file.h"
#include "tests/engine/files/scenario_fixture.h"
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
  EXPECT_EQ(read->bodies[1].pose, written.bodies[1].pose);  // equal bit by bit
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

TEST(ScenarioFile, AChecksumThatDoesNotFitIsAWarning) {
  const std::string text = writeScenario(fullScenario());
  const auto warningsOf = [](const std::string& content) {
    Warnings warnings;
    EXPECT_TRUE(parseScenario(content, "test.json", warnings).ok());
    return warnings;
  };
  EXPECT_TRUE(warningsOf(text).empty());
  EXPECT_TRUE(warningsOf(scenarioText(fullScenario())).empty());  // a file without a checksum
  std::string reformatted;
  for (const char c : text) reformatted += c == '\n' ? std::string("\r\n\t") : std::string(1, c);
  EXPECT_TRUE(warningsOf(reformatted).empty());
  std::string edited = text;
  edited.replace(edited.find("\"seed\": "), 9, "\"seed\": 1");
  const Warnings warnings = warningsOf(edited);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(toString(warnings[0].location), "/checksum");
  EXPECT_FALSE(warnings[0].advice.empty());
}

TEST(ScenarioFile, EveryChangedDigitIsSeen) {
  const std::string text = writeScenario(boxScenario());
  int seen = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] < '0' || text[i] > '9') continue;
    std::string damaged = text;
    damaged[i] = text[i] == '7' ? '8' : '7';
    Warnings warnings;
    const auto read = parseScenario(damaged, "test.json", warnings);
    EXPECT_TRUE(!read.ok() || warnings.size() == 1U) << "at " << i;
    ++seen;
  }
  EXPECT_GT(seen, 64);
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
  const SaveResult saved = saveScenarioFile(fullScenario(), file, std::nullopt);
  ASSERT_TRUE(saved.ok()) << toString(saved.why);
  EXPECT_EQ(saved.sha256, sha256(test::readWhole(file)));
  const Result<Scenario> read = parseScenario(test::readWhole(file), file);
  ASSERT_TRUE(read.ok());
  // Hash of the loaded content, not of the present file.
  EXPECT_EQ(read->assets[0].sha256, fullScenario().assets[0].sha256);
  EXPECT_EQ(read->assets[1].sha256, sha256("two"));
}

TEST(SaveScenario, ReplacesOnlyWhatWasOpenedAndKeepsEarlierVersions) {
  const TemporaryFolder folder;
  const std::string file = folder.write("scenario.json", writeScenario(boxScenario()));
  const auto opened = openScenarioFile(file);
  ASSERT_TRUE(opened.ok()) << toString(opened.error());
  Scenario mine = opened->scenario.scenario;
  mine.name = "mine";
  folder.write("scenario.json", "theirs");
  EXPECT_EQ(saveScenarioFile(mine, file, opened->sha256).status, SaveStatus::ChangedByOthers);
  EXPECT_EQ(test::readWhole(file), "theirs");
  ASSERT_TRUE(saveScenario(mine, file));
  const auto versions = earlierVersions(file);
  ASSERT_EQ(versions.size(), 1U);
  EXPECT_EQ(test::readWhole(versions[0].path), "theirs");
}

TEST(SaveScenario, RefusesWhatCouldNotBeLoadedAndKeepsTheOldFile) {
  const TemporaryFolder folder;
  const std::string file = folder.write("scenario.json", "old");
  Scenario broken = boxScenario();
  broken.start.position.x() = std::nan("");
  const SaveResult saved = saveScenarioFile(broken, file, std::nullopt);
  ASSERT_FALSE(saved.ok());
  EXPECT_THAT(toString(saved.why.location), testing::HasSubstr("/start/position/0"));
  EXPECT_FALSE(saveScenario(fullScenario(), file).ok());  // its assets do not exist
  EXPECT_EQ(test::readWhole(file), "old");
}

}  // namespace
}  // namespace glissade
