// The files of the samples equal the output of their generators.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "engine/files/scenario_io.h"
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

/// Compares the output of a generator with the files of the sample; returns the number of files.
int compareWithGenerator(const std::string& sample) {
  const test::TemporaryFolder folder;
  const std::string command = test::programDirectory() + "/generate-" + sample + " " + folder.path();
  EXPECT_EQ(std::system(command.c_str()), 0);
  int compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(test::readWhole(entry.path().string()),
              test::readWhole(test::sourceDirectory() + "/samples/" + sample + "/" + name))
        << name;
    ++compared;
  }
  return compared;
}

TEST(Samples, AreWhatTheirGeneratorsWrite) {
  EXPECT_EQ(compareWithGenerator("shape-game"), 22);
  EXPECT_EQ(compareWithGenerator("bolted-brackets"), 5);
}

}  // namespace
}  // namespace glissade
