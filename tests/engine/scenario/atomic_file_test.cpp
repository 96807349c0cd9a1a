#include "engine/scenario/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::readWhole;
using test::TemporaryFolder;

std::ptrdiff_t filesIn(const TemporaryFolder& folder) {
  return std::distance(std::filesystem::directory_iterator(folder.path()), std::filesystem::directory_iterator());
}

TEST(AtomicFile, ReplacesTheWholeContentAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.json", "a long old content");
  ASSERT_TRUE(writeFileAtomically(file, "new").ok());
  EXPECT_EQ(readWhole(file), "new");
  EXPECT_EQ(filesIn(folder), 1);
}

TEST(AtomicFile, KeepsPermissionsAndLinks) {
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

TEST(AtomicFile, FailuresNameTheFile) {
  const TemporaryFolder folder;
  for (const std::string& file : {folder / "missing/a.json", folder.path(), std::string("/dev/full")}) {
    const Outcome outcome = writeFileAtomically(file, "new");
    ASSERT_FALSE(outcome.ok()) << file;
    EXPECT_EQ(outcome.error().kind, ErrorKind::Internal);
    EXPECT_EQ(outcome.error().file, file);
  }
  EXPECT_EQ(filesIn(folder), 0);
}

}  // namespace
}  // namespace glissade
