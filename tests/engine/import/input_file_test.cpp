#include "engine/import/input_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "engine/import/sha256.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

void expectRefused(const std::string& file, const std::string& reason) {
  const Result<std::string> content = readInputFile(file, 1000);
  ASSERT_FALSE(content.ok());
  EXPECT_EQ(content.error().kind, ErrorKind::MalformedInput);
  EXPECT_EQ(content.error().file, file);
  EXPECT_THAT(content.error().reason, HasSubstr(reason));
  EXPECT_FALSE(content.error().advice.empty());
}

TEST(InputFile, IsReadAsItIs) {
  const TemporaryFolder folder;
  const std::string content("a\0b\r\n", 5);
  const Result<std::string> read = readInputFile(folder.write("file", content), 5);
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(*read, content);
}

TEST(InputFile, RefusesWhatIsNoOrdinaryFile) {
  const TemporaryFolder folder;
  expectRefused(folder / "missing", "No such file");
  expectRefused(folder.path(), "folder");
  expectRefused(folder.write("empty", ""), "empty");
  expectRefused("/dev/zero", "not a regular file");
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  expectRefused(folder / "fifo", "not a regular file");  // and does not wait for a writer
}

TEST(InputFile, RefusesWhatIsTooLargeWithoutReadingIt) {
  const TemporaryFolder folder;
  const std::string file = folder.write("large", "x");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40);  // sparse: a terabyte of nothing
  const Result<std::string> content = readInputFile(file, kLargestMeshFile);
  ASSERT_FALSE(content.ok());
  EXPECT_THAT(content.error().reason, HasSubstr("MB"));
}

TEST(InputFile, PathsStayInsideTheFolder) {
  const TemporaryFolder folder;
  folder.write("inside/part.stl", "x");
  folder.write("secret", "x");
  std::filesystem::create_symlink("../secret", folder / "inside/link");
  const std::string root = folder / "inside";
  EXPECT_TRUE(resolveInside(root, "part.stl").ok());
  EXPECT_TRUE(resolveInside(root, "not/there/yet.stl").ok());
  for (const char* path : {"", "/etc/passwd", "../secret", "a/../../secret", "a\\b", "link"}) {
    const Result<std::string> resolved = resolveInside(root, path);
    ASSERT_FALSE(resolved.ok()) << path;
    EXPECT_EQ(resolved.error().kind, ErrorKind::MalformedInput);
  }
  EXPECT_FALSE(isRelativeInside(std::string("a\0b", 3)));
}

TEST(InputFile, EndingsAreCaseless) {
  EXPECT_EQ(endingOf("/a.b/Part.STL"), "stl");
  EXPECT_EQ(endingOf("/a.b/part"), "");
  EXPECT_EQ(folderOf("part.stl"), ".");
}

TEST(Sha256, HasTheValuesOfTheStandard) {
  // FIPS 180-4, examples "abc" and the empty message.
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace
}  // namespace glissade
