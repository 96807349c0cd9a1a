#include "widgets/scene3d/shape_detail.h"

#include <gtest/gtest.h>

#include <cmath>

#include "widgets/scene3d/body_shape.h"

namespace glissade {
namespace {

constexpr double kRadius = 0.1;

/// A cylinder without lids: smooth around its axis, and open at its ends.
TriangleMesh tube(std::uint32_t around, std::uint32_t along) {
  TriangleMesh mesh;
  for (std::uint32_t j = 0; j <= along; ++j) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const double angle = 2.0 * std::acos(-1.0) * i / around;
      mesh.vertices.emplace_back(kRadius * std::cos(angle), kRadius * std::sin(angle), 0.2 * j / along);
    }
  }
  for (std::uint32_t j = 0; j < along; ++j) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t next = (i + 1) % around;
      const std::uint32_t a = j * around + i;
      const std::uint32_t b = j * around + next;
      mesh.triangles.push_back({a, b, b + around});
      mesh.triangles.push_back({a, b + around, a + around});
    }
  }
  return mesh;
}

TEST(ShapeDetail, AMeshOfFewTrianglesHasNoCoarserOnes) {
  EXPECT_TRUE(coarserDetails(makeBodyShape(tube(20, 10))).empty());
}

TEST(ShapeDetail, EachDetailHasFewerTrianglesAndALargerError) {
  const BodyShape shape = makeBodyShape(tube(200, 50));
  const std::vector<ShapeDetail> coarser = coarserDetails(shape);
  ASSERT_GE(coarser.size(), 3U);
  const ShapeDetail* finer = &shape;
  for (const ShapeDetail& detail : coarser) {
    EXPECT_LT(detail.corners->size(), finer->corners->size());
    EXPECT_EQ(detail.corners->size(), detail.normals->size());
    EXPECT_GT(detail.error, finer->error);
    EXPECT_LE(detail.edges->size(), finer->edges->size());
    finer = &detail;
  }
  EXPECT_LT(coarser.back().corners->size(), 600U);
}

TEST(ShapeDetail, CornersAreThoseOfTheMeshAndNormalsLookOutwards) {
  for (const ShapeDetail& detail : coarserDetails(makeBodyShape(tube(200, 50)))) {
    for (std::size_t i = 0; i + 2 < detail.corners->size(); i += 3) {
      const osg::Vec3& a = (*detail.corners)[i];
      const osg::Vec3& b = (*detail.corners)[i + 1];
      const osg::Vec3& c = (*detail.corners)[i + 2];
      EXPECT_NEAR(std::hypot(a.x(), a.y()), kRadius, 1e-6);  // the vertices are a subset of the mesh's
      EXPECT_GE(((b - a) ^ (c - a)) * ((*detail.normals)[i] + (*detail.normals)[i + 1] + (*detail.normals)[i + 2]),
                0.0);
    }
  }
}

}  // namespace
}  // namespace glissade
