#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "engine/geometry/mesh_audit.h"
#include "engine/geometry/primitives.h"
#include "engine/import/mesh_import.h"
#include "tests/engine/support/mesh_files.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/temporary_folder.h"

namespace glissade {
namespace {

using test::kMeshFormats;
using test::MeshFormat;
using test::TemporaryFolder;

Result<ImportedMesh> imported(MeshFormat format, const std::vector<TriangleMesh>& solids) {
  const TemporaryFolder folder;
  return importMesh(folder.write("part." + endingOf(format), meshFile(format, solids)));
}

/// Largest distance between corners of the same triangle.
double largestDifference(const TriangleMesh& a, const TriangleMesh& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 difference = a.vertices[a.triangles[i][k]] - b.vertices[b.triangles[i][k]];
      largest = std::max(largest, difference.cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

TEST(MeshAccuracy, ACubeOfSixMicrometresKeepsItsCorners) {
  const TriangleMesh cube = makeBox({6e-6, 6e-6, 6e-6});
  for (const MeshFormat format : kMeshFormats) {
    SCOPED_TRACE(static_cast<int>(format));
    const auto result = imported(format, {cube});
    ASSERT_TRUE(result.ok()) << toString(result.error());
    const MeshAudit found = audit(result->mesh);
    EXPECT_EQ(found.triangles, 12U);
    EXPECT_EQ(found.degenerateTriangles, 0U);
    EXPECT_TRUE(found.closed());
    EXPECT_EQ(welded(result->mesh).vertices.size(), 8U);
    EXPECT_NEAR(found.volume, 216e-18, 1e-6 * 216e-18);
  }
}

TEST(MeshAccuracy, AThinPinKeepsAllOfItsTriangles) {
  TriangleMesh pin;  // 60 micrometres wide, 64 segments
  constexpr std::uint32_t kSegments = 64;
  for (std::uint32_t i = 0; i < kSegments; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * i / kSegments;
    pin.vertices.emplace_back(30e-6 * std::cos(angle), 30e-6 * std::sin(angle), 0.0);
    pin.vertices.emplace_back(30e-6 * std::cos(angle), 30e-6 * std::sin(angle), 1e-3);
  }
  pin.vertices.emplace_back(0.0, 0.0, 0.0);
  pin.vertices.emplace_back(0.0, 0.0, 1e-3);
  for (std::uint32_t i = 0; i < kSegments; ++i) {
    const std::uint32_t a = 2 * i;
    const std::uint32_t b = 2 * ((i + 1) % kSegments);
    pin.triangles.insert(pin.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}, {b, a, 128}, {a + 1, b + 1, 129}});
  }
  for (const MeshFormat format : kMeshFormats) {
    SCOPED_TRACE(static_cast<int>(format));
    const auto result = imported(format, {pin});
    ASSERT_TRUE(result.ok()) << toString(result.error());
    EXPECT_EQ(welded(result->mesh).triangles.size(), 4U * kSegments);
    EXPECT_TRUE(audit(result->mesh).closed());
  }
}

TEST(MeshAccuracy, ACubeFarAwayIsExactOrRefused) {
  const TriangleMesh cube = transformed(makeBox({0.01, 0.01, 0.01}), Pose::translation({1e5, 0, 0}));
  for (const MeshFormat format : kMeshFormats) {
    SCOPED_TRACE(static_cast<int>(format));
    const auto result = imported(format, {cube});
    ASSERT_EQ(result.ok(), isExact(format));
    if (result) {
      EXPECT_EQ(largestDifference(result->mesh, cube), 0.0);
      EXPECT_EQ(result->coordinateSpacing, 0.0);
    } else {
      EXPECT_THAT(toString(result.error().reason), testing::HasSubstr("too coarse for a part"));
    }
  }
}

TEST(MeshAccuracy, CoordinatesAreTheFilesOrWithinTheirSpacing) {
  RandomStream random(5, "accuracy");
  for (int i = 0; i < 30; ++i) {
    const MeshFormat format = kMeshFormats[i % std::size(kMeshFormats)];
    SCOPED_TRACE(static_cast<int>(format));
    const double scale = std::pow(10.0, random.uniform(-6.0, 5.0));
    const TriangleMesh part = transformed(makeBox(scale * Vector3(1, 2, 3)), randomPose(random, 10.0 * scale));
    const auto result = imported(format, {part});
    ASSERT_TRUE(result.ok()) << toString(result.error());
    ASSERT_EQ(result->mesh.triangles.size(), part.triangles.size());
    const double difference = largestDifference(result->mesh, part);
    EXPECT_LE(difference, result->coordinateSpacing);
    EXPECT_EQ(result->coordinateSpacing == 0.0, isExact(format));
    if (!isExact(format)) {
      EXPECT_GT(difference, 0.0);
    }
    EXPECT_LT(result->coordinateSpacing, 1e-5 * scale);
  }
}

/// A second reader, which only searches keywords, gives the expected counts.
TEST(MeshAccuracy, NoTriangleOfTwoHundredFilesIsMissing) {
  RandomStream random(9, "differential");
  for (int i = 0; i < 200; ++i) {
    const MeshFormat format = kMeshFormats[i % std::size(kMeshFormats)];
    SCOPED_TRACE(testing::Message() << "file " << i << ", format " << static_cast<int>(format));
    std::vector<TriangleMesh> solids;
    const std::uint64_t count = 1 + random.bits() % 4;
    for (std::uint64_t k = 0; k < count; ++k) {
      const double size = std::pow(10.0, random.uniform(-2.0, 2.0));
      const TriangleMesh shapes[] = {makeBox({size, 0.7 * size, 0.3 * size}), makeCylinder(size, 0.5 * size),
                                     makeSphere(size)};
      solids.push_back(transformed(shapes[random.bits() % 3], randomPose(random, 1.0)));
    }
    const std::string content = meshFile(format, solids);
    const TemporaryFolder folder;
    const auto result = importMesh(folder.write("part." + endingOf(format), content));
    ASSERT_TRUE(result.ok()) << toString(result.error());
    EXPECT_EQ(result->mesh.triangles.size(), countTriangles(format, content));
    EXPECT_TRUE(result->warnings.empty());
    if (isExact(format)) {
      EXPECT_TRUE(audit(result->mesh).closed());
    }
  }
}

}  // namespace
}  // namespace glissade
