#include "engine/import/small_meshes.h"

#include <gtest/gtest.h>

#include "engine/geometry/primitives.h"
#include "tests/engine/support/part_fixture.h"

namespace glissade {
namespace {

FileContent box(int number) {
  const Vector3 size(1.0 + 0.001 * number, 2.0, 3.0);
  return {"box-" + std::to_string(number) + ".obj", test::toObj(makeBox(size))};
}

TEST(SmallMeshes, AreWhatTheyAreAlone) {
  std::vector<FileContent> files;
  for (int i = 0; i < 150; ++i) files.push_back(box(i));  // more files than two processes read
  files.push_back({"last.obj", box(0).bytes + "g lid\n# the end"});
  const auto meshes = importSmallMeshes(files);
  ASSERT_EQ(meshes.size(), files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto alone = importMesh(files[i]);
    ASSERT_TRUE(alone && meshes[i]) << i;
    EXPECT_EQ(meshes[i]->mesh.vertices, alone->mesh.vertices) << i;
    EXPECT_EQ(meshes[i]->mesh.triangles, alone->mesh.triangles) << i;
    EXPECT_EQ(meshes[i]->vertexMean, alone->vertexMean) << i;
    EXPECT_EQ(meshes[i]->warnings.size(), alone->warnings.size()) << i;
  }
  ASSERT_EQ(meshes.back()->warnings.size(), 1U) << "the last line has no end";
  EXPECT_EQ(meshes.back()->warnings.front().file, "last.obj");
}

TEST(SmallMeshes, ABrokenFileCostsTheOthersNothing) {
  const std::vector<FileContent> files{box(0),
                                       {"broken.obj", "v 0 0\nf 1 2 3\n"},
                                       {"empty.obj", "# nothing\n"},
                                       {"broken.glb", "glTF"},
                                       {"broken.stl", std::string(100, 'x')},
                                       box(1)};
  const auto meshes = importSmallMeshes(files);
  EXPECT_TRUE(meshes.front().has_value());
  EXPECT_TRUE(meshes.back().has_value());
  for (std::size_t i = 1; i + 1 < files.size(); ++i) {
    EXPECT_FALSE(meshes[i].has_value()) << files[i].file;
    EXPECT_FALSE(importMesh(files[i]).ok()) << files[i].file;
  }
}

/// Simulates a process that ends early.
TEST(SmallMeshes, WhatIsNotAnsweredIsLeftToBeReadAlone) {
  StopSource source;
  source.requestStop();
  const std::vector<FileContent> files{box(0), box(1)};
  for (const auto& mesh : importSmallMeshes(files, source.token())) EXPECT_FALSE(mesh.has_value());
}

TEST(SmallMeshes, AreSmallAndOfAFormatThatIsReadByThisProject) {
  EXPECT_TRUE(isSmallMesh("part.OBJ", 1000));
  EXPECT_FALSE(isSmallMesh("part.obj", 0));
  EXPECT_FALSE(isSmallMesh("part.obj", 10U << 20U));
  EXPECT_FALSE(isSmallMesh("part.dae", 1000));
  EXPECT_FALSE(isSmallMesh("part.step", 1000));
}

}  // namespace
}  // namespace glissade
