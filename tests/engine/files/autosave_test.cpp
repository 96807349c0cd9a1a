#include "engine/files/autosave.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "engine/files/scenario_io.h"
#include "tests/engine/files/scenario_fixture.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::TemporaryFolder;

UnsavedEdits someEdits(const std::string& file) {
  UnsavedEdits edits{file, std::string(64, 'a'), test::boxScenario()};
  edits.scenario.assets.push_back({"part", "meshes/part.stl", "", 1.0, UpAxis::Z});
  edits.scenario.name = "edited";
  return edits;
}

/// A program that writes edits and is killed.
void writeAndDie(const std::string& folder, const UnsavedEdits& edits) {
  const pid_t child = ::fork();
  if (child == 0) {
    auto slot = AutosaveSlot::make(folder);
    if (!slot || !(*slot)->write(UnsavedEdits{"", "", test::boxScenario()}) || !(*slot)->write(edits)) ::_exit(1);
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
}

TEST(Autosave, AKilledProgramLeavesItsLastEdits) {
  const TemporaryFolder folder;
  const std::string file = folder.write("project/a.json", "as it was opened");
  const UnsavedEdits edits = someEdits(file);
  writeAndDie(folder / "autosave", edits);
  auto found = findAbandonedEdits(folder / "autosave");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(findAbandonedEdits(folder / "autosave").empty());  // one program is using it
  const auto read = found[0].read();
  ASSERT_TRUE(read.ok()) << toString(read.error());
  EXPECT_EQ(read->file, file);
  EXPECT_EQ(read->sha256, edits.sha256);
  EXPECT_EQ(writeScenario(read->scenario), writeScenario(edits.scenario));
  EXPECT_EQ(test::readWhole(file), "as it was opened");
  found.clear();
  found = findAbandonedEdits(folder / "autosave");  // no program has removed it
  ASSERT_EQ(found.size(), 1U);
  found[0].remove();
  found.clear();
  EXPECT_TRUE(std::filesystem::is_empty(folder / "autosave"));
}

TEST(Autosave, OfAScenarioWithoutAFileFindsItsAssets) {
  const TemporaryFolder folder;
  UnsavedEdits edits = someEdits("");
  edits.sha256.clear();
  edits.scenario.assets.back().path = folder / "part.stl";
  writeAndDie(folder / "autosave", edits);
  const auto found = findAbandonedEdits(folder / "autosave");
  ASSERT_EQ(found.size(), 1U);
  const auto read = found[0].read();
  ASSERT_TRUE(read.ok()) << toString(read.error());
  EXPECT_EQ(read->file, "");
  EXPECT_TRUE(std::filesystem::equivalent(std::filesystem::path(folder.path()),
                                          std::filesystem::absolute(read->scenario.assets.back().path).parent_path()));
}

TEST(Autosave, ALivingProgramsEditsAreItsOwnAndGoWithIt) {
  const TemporaryFolder folder;
  auto slot = AutosaveSlot::make(folder / "autosave");
  ASSERT_TRUE(slot.ok()) << toString(slot.error());
  ASSERT_TRUE((*slot)->write(someEdits("")).ok());
  EXPECT_TRUE(findAbandonedEdits(folder / "autosave").empty());
  slot->reset();
  EXPECT_TRUE(std::filesystem::is_empty(folder / "autosave"));
}

TEST(Autosave, OneThatIsDamagedIsNotRestored) {
  const TemporaryFolder folder;
  writeAndDie(folder / "autosave", someEdits("/a.json"));
  const auto found = findAbandonedEdits(folder / "autosave");
  ASSERT_EQ(found.size(), 1U);
  std::string text = test::readWhole(found[0].file());
  text[text.find("edited")] = 'E';
  std::ofstream(found[0].file(), std::ios::binary) << text;
  const auto read = found[0].read();
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(toString(read.error().location), "/checksum");
}

TEST(Autosave, SaysThatAFolderCannotBeUsed) {
  const TemporaryFolder folder;
  const auto slot = AutosaveSlot::make(folder.write("file", "") + "/below");
  ASSERT_FALSE(slot.ok());
  EXPECT_THAT(toString(slot.error().advice), testing::HasSubstr("not saved automatically"));
}

}  // namespace
}  // namespace glissade
