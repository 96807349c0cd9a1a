#include "engine/files/asset_path.h"

#include <gtest/gtest.h>

#include "engine/files/same_problem.h"
#include "engine/files/scenario_io.h"
#include "tests/engine/files/scenario_fixture.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::TemporaryFolder;

Scenario withAsset(const std::string& path) {
  Scenario scenario = test::boxScenario();
  scenario.assets = {{"part", path, "", 1.0, UpAxis::Z}};
  return scenario;
}

std::string moved(const std::string& path, const std::string& oldFile, const std::string& newFile) {
  return movedTo(newFile, withAsset(path), oldFile).assets[0].path;
}

TEST(MovedTo, NamesAssetsAsSeenFromTheNewFile) {
  EXPECT_EQ(moved("part.stl", "/none/old/a.json", "/none/old/b.json"), "part.stl");
  EXPECT_EQ(moved("part.stl", "/none/old/a.json", "/none/new/a.json"), "../old/part.stl");
  EXPECT_EQ(moved("../old/part.stl", "/none/new/a.json", "/none/old/a.json"), "part.stl");
  EXPECT_EQ(moved("meshes/part.stl", "/none/a.json", "/none/meshes/a.json"), "part.stl");
  EXPECT_EQ(moved("/none/parts/part.stl", "/none/old/a.json", "/none/new/a.json"), "../parts/part.stl");
}

TEST(MovedTo, NamesWhatSharesOnlyTheRootAbsolutely) {
  EXPECT_EQ(moved("part.stl", "/none/old/a.json", "/elsewhere/a.json"), "/none/old/part.stl");
  EXPECT_EQ(moved("part.stl", "/none/old/a.json", "/a.json"), "/none/old/part.stl");
}

TEST(MovedTo, KeepsEverythingElse) {
  const Scenario old = test::fullScenario();
  Scenario there = movedTo("/none/new/a.json", old, "/none/old/a.json");
  for (std::size_t i = 0; i < old.assets.size(); ++i) there.assets[i].path = old.assets[i].path;
  EXPECT_EQ(writeScenario(there), writeScenario(old));
}

TEST(MovedTo, SeesThroughLinkedFolders) {
  const TemporaryFolder folder;
  folder.write("real/deep/part.stl", "x");
  folder.write("new/other.stl", "x");
  std::filesystem::create_symlink(folder / "real/deep", folder / "link");
  const std::string path = moved("part.stl", folder / "link/a.json", folder / "new/a.json");
  EXPECT_EQ(path, "../real/deep/part.stl");
  EXPECT_TRUE(std::filesystem::exists(assetFile(withAsset(path).assets[0], folder / "new")));
  EXPECT_TRUE(std::filesystem::exists(assetFile(withAsset("../deep/part.stl").assets[0], folder / "link")));
}

TEST(MovedTo, IsStillTheSameProblemAndComesBackAsItWas) {
  const auto loaded = loadScenario(test::sample("environment-1"));
  ASSERT_TRUE(loaded.ok()) << toString(loaded.error());
  const TemporaryFolder folder;
  const std::string elsewhere = folder / "elsewhere.json";
  ASSERT_TRUE(saveScenario(movedTo(elsewhere, loaded->scenario, loaded->file), elsewhere).ok());
  const auto there = loadScenario(elsewhere);
  ASSERT_TRUE(there.ok()) << toString(there.error());
  EXPECT_TRUE(there->warnings.empty());
  EXPECT_EQ(problemSha256(there->scenario), problemSha256(loaded->scenario));
  EXPECT_EQ(writeScenario(movedTo(loaded->file, there->scenario, elsewhere)), writeScenario(loaded->scenario));
}

}  // namespace
}  // namespace glissade
