#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "engine/base/file.h"
#include "engine/files/scenario_io.h"
#include "engine/geometry/primitives.h"
#include "tests/engine/files/scenario_fixture.h"
#include "tests/engine/support/independent_check.h"
#include "tests/engine/support/mesh_files.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::MeshFormat;
using test::TemporaryFolder;
using testing::HasSubstr;

/// boxScenario with its object and its one body from mesh files.
Scenario meshScenario(const std::string& object, const std::string& body) {
  Scenario scenario = test::boxScenario();
  scenario.assets = {{"object", object, "", 1.0, UpAxis::Z}, {"body", body, "", 1.0, UpAxis::Z}};
  scenario.object.first().geometry = MeshGeometry{"object"};
  scenario.bodies.resize(1);
  scenario.bodies[0].geometry = MeshGeometry{"body"};
  scenario.bodies[0].pose = Pose::identity();
  return scenario;
}

TEST(MeshAsset, APathThroughTheCornerOfATinyCubeIsNotCertified) {
  for (const MeshFormat format : test::kMeshFormats) {
    SCOPED_TRACE(static_cast<int>(format));
    const TemporaryFolder folder;
    const std::string cube = "cube." + test::endingOf(format);
    const std::string tool = "tool." + test::endingOf(format);
    folder.write(cube, meshFile(format, {makeBox({6e-6, 6e-6, 6e-6})}));
    folder.write(tool, meshFile(format, {makeBox({1e-6, 1e-6, 1e-6})}));
    const auto loaded = loadGeometry(meshScenario(tool, cube), folder.path(), "s.json");
    ASSERT_TRUE(loaded.ok()) << toString(loaded.error());
    EXPECT_TRUE(loaded->warnings.empty());
    const IndependentCheck judge(loaded->obstacles, *loaded->object.mesh);
    const auto statusAt = [&](double y) {
      const std::vector<Pose> path{Pose::translation({-2e-5, y, y}), Pose::translation({2e-5, y, y})};
      return judge.check(path, {{1e-9, false}}).status;
    };
    EXPECT_EQ(statusAt(3.4e-6), CertificateStatus::Violated);  // 0.1 micrometres into the corner
    EXPECT_EQ(statusAt(3.6e-6), CertificateStatus::Certified);
  }
}

TEST(MeshAsset, SpacingsOfCoordinatesAreInMetresAndAddUp) {
  const TemporaryFolder folder;
  folder.write("part.stl", meshFile(MeshFormat::BinaryStl, {makeBox({100, 100, 100})}));
  folder.write("other.obj", meshFile(MeshFormat::Obj, {makeBox({100, 100, 100})}));
  Scenario scenario = meshScenario("part.stl", "part.stl");
  scenario.assets[1].unit = 0.001;
  const auto both = loadGeometry(scenario, folder.path(), "s.json");
  ASSERT_TRUE(both.ok()) << toString(both.error());
  const double spacing = std::nextafter(50.0F, 51.0F) - 50.0F;
  EXPECT_DOUBLE_EQ(both->coordinateSpacings.at(scenario.object.first().id), spacing);
  EXPECT_DOUBLE_EQ(both->coordinateSpacings.at(scenario.bodies[0].id), 0.001 * spacing);
  EXPECT_DOUBLE_EQ(coordinateSpacing(*both), 1.001 * spacing);
  const auto exact = loadGeometry(meshScenario("other.obj", "other.obj"), folder.path(), "s.json");
  ASSERT_TRUE(exact.ok());
  EXPECT_EQ(coordinateSpacing(*exact), 0.0);
}

TEST(MeshAsset, WhatIsSavedIsTheHashOfWhatWasLoaded) {
  const TemporaryFolder folder;
  const std::string first = meshFile(MeshFormat::Obj, {makeBox({1, 1, 1})});
  const std::string second = meshFile(MeshFormat::Obj, {makeBox({2, 1, 1})});
  folder.write("part.obj", first);
  const auto loaded = loadGeometry(meshScenario("part.obj", "part.obj"), folder.path(), folder / "s.json");
  ASSERT_TRUE(loaded.ok());
  folder.write("part.obj", second);  // a program exports it again
  ASSERT_TRUE(saveScenario(loaded->scenario, folder / "s.json").ok());
  const auto saved = parseScenario(test::readWhole(folder / "s.json"), "s.json");
  ASSERT_TRUE(saved.ok());
  EXPECT_EQ(saved->assets[0].sha256, sha256(first));
  const auto again = loadScenario(folder / "s.json");
  ASSERT_TRUE(again.ok());
  ASSERT_FALSE(again->warnings.empty());
  EXPECT_THAT(toString(again->warnings[0].reason), HasSubstr("changed"));
  EXPECT_EQ(again->scenario.assets[0].sha256, sha256(second));
}

TEST(MeshAsset, TrianglesThatAreLeftOutAreCounted) {
  const TemporaryFolder folder;
  folder.write("part.obj", meshFile(MeshFormat::Obj, {makeBox({1, 1, 1})}) + "f 1 1 2\nf 3 3 3\n");
  const auto loaded = loadGeometry(meshScenario("part.obj", "part.obj"), folder.path(), "s.json");
  ASSERT_TRUE(loaded.ok()) << toString(loaded.error());
  ASSERT_EQ(loaded->warnings.size(), 1U);  // both bodies come from the file, which is read once
  EXPECT_THAT(toString(loaded->warnings[0].reason), HasSubstr("has 2 triangles with two equal corners"));
  EXPECT_EQ(loaded->obstacles[0].mesh->triangles.size(), 12U);
}

TEST(MeshAsset, AFileThatIsTooLargeIsRefusedWithItsSizeAndTheLimit) {
  const TemporaryFolder folder;
  const std::string file = folder.write("part.stl", "solid");
  std::filesystem::resize_file(file, 5ULL << 30);  // takes no space on the disk
  const auto loaded = loadGeometry(meshScenario("part.stl", "part.stl"), folder.path(), "s.json");
  ASSERT_FALSE(loaded.ok());
  EXPECT_THAT(toString(loaded.error().reason), HasSubstr("it has 5120 MiB, and at most "));
}

}  // namespace
}  // namespace glissade
