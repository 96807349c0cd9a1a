// Gives files that hung or misled other importers to glissade-cli.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

#include "tests/engine/support/directories.h"
#include "tests/engine/support/temporary_folder.h"
#include "tests/oracle/child_run.h"
#include "tests/oracle/mesh_writer.h"
#include "tests/oracle/shapes.h"

namespace glissade::reliability {
namespace {

using oracle::ChildEnd;
using test::TemporaryFolder;
using testing::HasSubstr;

constexpr int kMalformed = 3;

/// A scenario with an object from a mesh file, and a wall.
std::string scenarioWith(const std::string& asset) {
  return R"({"format": "glissade-scenario", "version": 1, "name": "t",
    "assets": [{"id": "part", "path": ")" +
         asset + R"("}],
    "bodies": [{"id": "wall", "name": "wall", "geometry": {"box": [1, 1, 1]},
                "pose": {"position": [0, 0, 0], "orientation": [0, 0, 0, 1]}}],
    "object": {"id": "object", "name": "object", "geometry": {"mesh": "part"}},
    "start": {"position": [-2.5, 0, 0], "orientation": [0, 0, 0, 1]},
    "goal": {"position": [2.5, 0, 0], "orientation": [0, 0, 0, 1]},
    "workspace": {"min": [-3, -3, -3], "max": [3, 3, 3]}})";
}

std::string cli() { return test::programDirectory() + "/glissade-cli"; }

ChildEnd infoOf(const TemporaryFolder& folder, const std::string& asset) {
  return oracle::runChild({cli(), "info", folder.write("scenario.json", scenarioWith(asset)), "--json"}, {60, 2048});
}

std::string somePart(oracle::MeshFormat format) { return meshFile(oracle::box(0.5, 0.25, 0.25), format); }

TEST(HostileFiles, WhatIsNoRegularFileIsRefusedAndNeverWaitedFor) {
  const TemporaryFolder folder;
  for (const std::string ending : {".stl", ".obj", ".glb", ".dae"}) {
    ASSERT_EQ(::mkfifo((folder / ("fifo" + ending)).c_str(), 0600), 0);
    ASSERT_EQ(::mkdir((folder / ("folder" + ending)).c_str(), 0700), 0);
    ASSERT_EQ(::symlink("/dev/zero", (folder / ("zero" + ending)).c_str()), 0);
    for (const std::string name : {"fifo", "folder", "zero", "missing"}) {
      const ChildEnd end = infoOf(folder, name + ending);
      EXPECT_FALSE(end.hung) << name << ending;
      EXPECT_EQ(end.exitCode, kMalformed) << name << ending << end.errors;
      EXPECT_THAT(end.errors, HasSubstr(name + ending));
    }
  }
}

/// An importer that opened the references of the file would wait for the FIFO's writer.
TEST(HostileFiles, WhatAMeshFileNamesIsNotOpened) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  ASSERT_EQ(::mkdir((folder / "parts").c_str(), 0700), 0);
  folder.write("parts/part.obj", "mtllib ../fifo\n" + somePart(oracle::MeshFormat::Obj));
  const ChildEnd withMaterial = infoOf(folder, "parts/part.obj");
  EXPECT_FALSE(withMaterial.hung);
  EXPECT_EQ(withMaterial.exitCode, 0) << withMaterial.errors;
  folder.write("parts/part.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "buffers": [{"uri": "../fifo", "byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}]})");
  const ChildEnd withBuffer = infoOf(folder, "parts/part.gltf");
  EXPECT_FALSE(withBuffer.hung);
  EXPECT_EQ(withBuffer.exitCode, kMalformed) << withBuffer.errors;
}

/// "1,5" ends a number in the C locale, and "1.5" in a locale with a decimal comma.
TEST(HostileFiles, NumbersDoNotDependOnTheLocale) {
  const TemporaryFolder folder;
  folder.write("part.stl", somePart(oracle::MeshFormat::TextStl));
  ASSERT_EQ(::setenv("LC_ALL", "C.UTF-8", 1), 0);
  const ChildEnd plain = infoOf(folder, "part.stl");
  ASSERT_EQ(::setenv("LC_ALL", "fr_FR.UTF-8", 1), 0);
  const ChildEnd french = infoOf(folder, "part.stl");
  ::unsetenv("LC_ALL");
  ASSERT_EQ(plain.exitCode, 0) << plain.errors;
  EXPECT_EQ(french.output, plain.output);
  EXPECT_THAT(plain.output, HasSubstr("-2.75"));
}

}  // namespace
}  // namespace glissade::reliability
