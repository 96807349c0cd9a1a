#include "engine/import/safe_path.h"

#include <gtest/gtest.h>

#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::TemporaryFolder;

TEST(SafePath, StaysBelowTheFolder) {
  const TemporaryFolder folder;
  folder.write("inside/part.stl", "x");
  folder.write("secret", "x");
  std::filesystem::create_symlink("../secret", folder / "inside/link");
  const std::string root = folder / "inside";
  EXPECT_EQ(*resolveBelow(root, "part.stl", "s.json", "here"), root + "/part.stl");
  EXPECT_TRUE(resolveBelow(root, "not/there/yet.stl", "s.json", "here").ok());
  EXPECT_TRUE(resolveBelow(root, "a/../part.stl", "s.json", "here").ok());
  for (const char* path : {"", "/etc/passwd", "../secret", "a/../../secret", "link"}) {
    const Result<std::string> resolved = resolveBelow(root, path, "s.json", "here");
    ASSERT_FALSE(resolved.ok()) << path;
    EXPECT_EQ(resolved.error().kind, ErrorKind::MalformedInput);
    EXPECT_EQ(resolved.error().file, "s.json");
    EXPECT_EQ(toString(resolved.error().location), "here");
  }
}

}  // namespace
}  // namespace glissade
