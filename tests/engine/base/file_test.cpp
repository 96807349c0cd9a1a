#include "engine/base/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>

#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::readWhole;
using test::TemporaryFolder;

std::ptrdiff_t filesIn(const TemporaryFolder& folder) {
  return std::distance(std::filesystem::directory_iterator(folder.path()), std::filesystem::directory_iterator());
}

void expectRefused(const std::string& file, const std::string& reason) {
  const Result<std::string> content = readFile(file, 1000);
  ASSERT_FALSE(content.ok());
  EXPECT_EQ(content.error().kind, ErrorKind::MalformedInput);
  EXPECT_EQ(content.error().file, file);
  EXPECT_THAT(toString(content.error().reason), testing::HasSubstr(reason));
  EXPECT_FALSE(content.error().advice.empty());
}

TEST(ReadFile, GivesTheContentAsItIs) {
  const TemporaryFolder folder;
  const std::string content("a\0b\r\n", 5);
  const Result<std::string> read = readFile(folder.write("file", content), 5);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(*read, content);
}

TEST(ReadFile, RefusesWhatIsNoOrdinaryFile) {
  const TemporaryFolder folder;
  expectRefused(folder / "missing", "No such file");
  expectRefused(folder.path(), "not a regular file");
  expectRefused("/dev/zero", "not a regular file");
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  expectRefused(folder / "fifo", "not a regular file");  // refused without waiting for a writer
}

TEST(ReadFile, RefusesWhatIsTooLarge) {
  const TemporaryFolder folder;
  const std::string file = folder.write("large", "x");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40);  // sparse file of a terabyte
  expectRefused(file, "too large");
}

TEST(WriteFileAtomically, ReplacesTheWholeContentAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.json", "a long old content");
  ASSERT_TRUE(writeFileAtomically(file, "new").ok());
  EXPECT_EQ(readWhole(file), "new");
  EXPECT_EQ(filesIn(folder), 1);
}

TEST(WriteFileAtomically, KeepsPermissionsAndLinks) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.json", "old");
  ASSERT_EQ(::chmod(file.c_str(), 0640), 0);
  std::filesystem::create_symlink("a.json", folder / "link.json");
  ASSERT_TRUE(writeFileAtomically(folder / "link.json", "new").ok());
  EXPECT_EQ(readWhole(file), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.json"));
  struct stat status {};
  ASSERT_EQ(::stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640U);
}

TEST(WriteFileAtomically, FailuresNameTheFileAndLeaveNothingBehind) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "folder");
  for (const std::string& file : {folder / "missing/a.json", folder / "folder"}) {
    const Outcome outcome = writeFileAtomically(file, "new");
    ASSERT_FALSE(outcome.ok()) << file;
    EXPECT_EQ(outcome.error().kind, ErrorKind::Unwritable);
    EXPECT_EQ(outcome.error().file, file);
  }
  EXPECT_EQ(filesIn(folder), 1);
}

TEST(Sha256, HasTheValuesOfTheStandard) {
  // Examples of FIPS 180-4: "abc" and the empty message.
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(EndingOf, IsInLowerCaseAndWithoutItsDot) {
  EXPECT_EQ(endingOf("/parts/Cover.v2.STL"), "stl");
  EXPECT_EQ(endingOf("/parts.stl/README"), "");
  EXPECT_EQ(endingOf(".stl"), "");
}

}  // namespace
}  // namespace glissade
