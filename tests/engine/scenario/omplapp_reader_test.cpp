#include "engine/scenario/omplapp_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "engine/scenario/check_problem.h"
#include "engine/scenario/path_io.h"
#include "engine/scenario/scenario_io.h"

namespace glissade {
namespace {

const std::string kConfig = R"([problem]
name = Test
robot = robot.dae
world = world.dae
# a comment
start.x = 1
start.y = 2
start.z = 3
start.theta = 1.5707963267948966
start.axis.x = 0
start.axis.y = 0
start.axis.z = 2
goal.x = 20
goal.y = 0
goal.z = 0
goal.theta = 0
goal.axis.x = 0
goal.axis.y = 0
goal.axis.z = 0
volume.min.x = -5
volume.min.y = -5
volume.min.z = -5
volume.max.x = 5
volume.max.y = 5
volume.max.z = 5
sampler = obstacle_based

[planner]
rrt =
not a key
)";

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = kConfig;
  return text.replace(text.find(from), from.size(), to);
}

TEST(OmplApp, IsReadAsOmplAppReadsIt) {
  const Result<Scenario> scenario = parseOmplApp(kConfig, "test.cfg");
  ASSERT_TRUE(scenario.ok()) << toString(scenario.error());
  EXPECT_EQ(scenario->name, "Test");
  EXPECT_TRUE(scenario->object.centreOnVertexMean);
  EXPECT_EQ(scenario->start.position, Vector3(1, 2, 3));
  EXPECT_TRUE((scenario->start.orientation * Vector3::UnitX()).isApprox(Vector3::UnitY(), 1e-12));
  EXPECT_EQ(scenario->workspace.max().x(), 20.0);  // grown to contain the goal
  EXPECT_EQ(scenario->workspace.min().x(), -5.0);
  EXPECT_TRUE(parseScenario(writeScenario(*scenario), "converted.json").ok());
}

TEST(OmplApp, FaultsAreNamedWithTheirLine) {
  const std::vector<std::tuple<std::string, std::string, std::string>> table{
      {replaced("start.x = 1", "start.x = 1,5"), "line 6", "not a finite number"},
      {replaced("start.x = 1", "start.x = nan"), "line 6", "not a finite number"},
      {replaced("start.x = 1", "start.x 1"), "line 6", "key = value"},
      {replaced("start.y = 2", "start.x = 2"), "line 7", "twice"},
      {replaced("start.axis.z = 2", "start.axis.z = 0"), "line 10", "axis"},
      {replaced("goal.z = 0\n", ""), "[problem]", "'goal.z' is missing"},
      {replaced("robot.dae", "../robot.dae"), "line 3", "leaves"},
      {replaced("volume.min.x = -5", "volume.min.x = 50"), "line 20", "below"},
      {"[planner]\n", "", "no section"},
      {"", "", "no section"},
  };
  for (const auto& [text, place, reason] : table) {
    SCOPED_TRACE(place + " " + reason);
    const Result<Scenario> scenario = parseOmplApp(text, "test.cfg");
    ASSERT_FALSE(scenario.ok());
    EXPECT_EQ(scenario.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(scenario.error().place, place);
    EXPECT_THAT(scenario.error().reason, testing::HasSubstr(reason));
  }
}

class OmplAppProblem : public testing::TestWithParam<const char*> {
 protected:
  std::string file(const std::string& ending) const {
    return std::string(GLISSADE_SOURCE_DIR) + "/../shared/problems/omplapp/" + GetParam() + ending;
  }
};

TEST_P(OmplAppProblem, LoadsAndItsSamplePathIsFree) {
  if (!std::filesystem::exists(file(".cfg"))) GTEST_SKIP() << "OMPL.app's problems are not here";
  const Result<LoadedScenario> loaded = loadScenario(file(".cfg"));
  ASSERT_TRUE(loaded.ok()) << toString(loaded.error());
  const Outcome free = checkStartAndGoal(*loaded);
  EXPECT_TRUE(free.ok()) << toString(free.error());
  if (!std::filesystem::exists(file(".path"))) return;

  const Result<std::vector<PathPoint>> path = readPath(file(".path"));
  ASSERT_TRUE(path.ok()) << toString(path.error());
  const auto query = loaded->problem.world->makeQuery();
  for (std::size_t i = 1; i < path->size(); ++i) {
    for (int k = 0; k <= 20; ++k) {
      EXPECT_FALSE(query->collides(interpolate((*path)[i - 1].q, (*path)[i].q, k / 20.0))) << "edge " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, OmplAppProblem,
                         testing::Values("Easy", "Twistycool", "alpha-1.5", "bugtrap", "cubicles"));

}  // namespace
}  // namespace glissade
