#include <gtest/gtest.h>

#include <filesystem>

#include "engine/files/path_reader.h"
#include "engine/files/scenario_io.h"
#include "tests/engine/support/directories.h"

namespace glissade {
namespace {

class OmplAppProblem : public testing::TestWithParam<const char*> {
 protected:
  std::string file(const std::string& ending) const {
    return test::sourceDirectory() + "/../shared/problems/omplapp/" + GetParam() + ending;
  }
};

TEST_P(OmplAppProblem, LoadsAndItsSamplePathIsFree) {
  if (!std::filesystem::exists(file(".cfg"))) GTEST_SKIP() << "OMPL.app's problems are not here";
  const Result<LoadedScenario> loaded = loadScenario(file(".cfg"));
  ASSERT_TRUE(loaded.ok()) << toString(loaded.error());
  const auto query = loaded->problem.world->makeQuery();
  EXPECT_FALSE(query->collides(loaded->problem.start));
  EXPECT_FALSE(query->collides(std::get<Pose>(loaded->problem.goal)));
  if (!std::filesystem::exists(file(".path"))) return;

  const Result<std::vector<PathPoint>> path = readPath(file(".path"));
  ASSERT_TRUE(path.ok()) << toString(path.error());
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
