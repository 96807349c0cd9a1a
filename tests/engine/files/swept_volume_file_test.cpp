#include "engine/files/swept_volume_file.h"

#include <gtest/gtest.h>

#include "engine/base/file.h"
#include "engine/geometry/primitives.h"
#include "engine/import/mesh_import.h"
#include "tests/engine/files/glb_content.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

SweptVolume sweepOfABox() {
  SweptVolume sweep;
  sweep.surface_W = makeBox({0.1, 0.2, 0.3});
  sweep.bound = 0.001;
  sweep.volume = 0.006;
  return sweep;
}

TEST(SweptVolumeFile, StlIsReadBackInMillimetres) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "swept.stl";
  Warnings warnings;
  ASSERT_TRUE(saveSweptVolume(sweepOfABox(), "box", {}, file, warnings));
  EXPECT_TRUE(warnings.empty());
  const Result<ImportedMesh> read = importMesh(file);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->mesh.triangles.size(), 12U);
  EXPECT_TRUE(boundingBox(read->mesh).sizes().isApprox(Vector3(100.0, 200.0, 300.0), 1e-6));
}

TEST(SweptVolumeFile, GlbSaysItsBound) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "swept.GLB";
  Warnings warnings;
  ASSERT_TRUE(saveSweptVolume(sweepOfABox(), "box", {}, file, warnings));
  const Result<std::string> bytes = readFile(file, 1U << 20);
  ASSERT_TRUE(bytes);
  const test::GlbContent glb(*bytes);
  EXPECT_EQ(glb.json["scenes"][0]["extras"]["bound_m"], 0.001);
  EXPECT_EQ(glb.json["scenes"][0]["extras"]["volume_m3"], 0.006);
}

TEST(SweptVolumeFile, AnotherEndingIsRefusedAndNothingIsWritten) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "swept.step";
  Warnings warnings;
  const Outcome saved = saveSweptVolume(sweepOfABox(), "box", {}, file, warnings);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().kind, ErrorKind::Usage);
  EXPECT_EQ(saved.error().file, file);
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace glissade
