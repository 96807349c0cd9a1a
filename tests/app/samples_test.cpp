// The samples are what their generators write.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "engine/scenario/scenario_io.h"
#include "tests/engine/support/directories.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

TEST(Samples, EveryScenarioIsReadWithoutAWarning) {
  int read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::sourceDirectory() + "/samples")) {
    if (entry.path().extension() != ".json") continue;
    const auto scenario = loadScenario(entry.path().string());
    if (!scenario.ok()) continue;  // a study
    EXPECT_TRUE(scenario->warnings.empty()) << entry.path();
    ++read;
  }
  EXPECT_GE(read, 16);
}

TEST(Samples, TheShapeGameIsWhatItsGeneratorWrites) {
  const test::TemporaryFolder folder;
  const std::string command = test::programDirectory() + "/generate-shape-game " + folder.path();
  ASSERT_EQ(std::system(command.c_str()), 0);
  int compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(test::readWhole(entry.path().string()),
              test::readWhole(test::sourceDirectory() + "/samples/shape-game/" + name))
        << name;
    ++compared;
  }
  EXPECT_EQ(compared, 22);
}

}  // namespace
}  // namespace glissade
