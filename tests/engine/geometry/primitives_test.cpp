#include "engine/geometry/primitives.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/base/random_stream.h"
#include "engine/geometry/mesh_audit.h"

namespace glissade {
namespace {

void expectSolid(const TriangleMesh& mesh) {
  const MeshAudit result = audit(mesh);
  EXPECT_TRUE(result.closed());
  EXPECT_TRUE(result.consistentlyOriented);
  EXPECT_EQ(result.degenerateTriangles, 0U);
  EXPECT_EQ(result.surfaces.size(), 1U);
  EXPECT_GT(result.volume, 0.0) << "triangles must face outwards";
}

TEST(Primitives, AreClosedAndFaceOutwards) {
  expectSolid(makeBox({1, 2, 3}));
  expectSolid(makeCylinder(0.5, 2.0));
  expectSolid(makeSphere(0.7));
}

TEST(Primitives, BoxHasItsVolumeAndIsCentred) {
  const MeshAudit box = audit(makeBox({1, 2, 3}));
  EXPECT_DOUBLE_EQ(box.volume, 6.0);
  EXPECT_TRUE(box.box.center().isZero(1e-15));
}

TEST(Primitives, RoundOnesContainTheTrueShapeAndHardlyMore) {
  const TriangleMesh cylinder = makeCylinder(0.25, 4.0);
  const TriangleMesh sphere = makeSphere(0.25);
  RandomStream stream(5, "surface");
  for (int i = 0; i < 200; ++i) {
    const double angle = stream.uniform(0, 2 * std::numbers::pi);
    const double inside = 0.25 * (1.0 - 1e-9);
    EXPECT_TRUE(
        containsPoint(cylinder, {inside * std::cos(angle), inside * std::sin(angle), stream.uniform(-1.9, 1.9)}));
    const Vector3 direction = Vector3(stream.normal(), stream.normal(), stream.normal()).normalized();
    EXPECT_TRUE(containsPoint(sphere, inside * direction));
  }
  EXPECT_LT(audit(cylinder).volume, 1.01 * std::numbers::pi * 0.0625 * 4.0);
  EXPECT_LT(audit(sphere).volume, 1.03 * 4.0 / 3.0 * std::numbers::pi * 0.015625);
}

}  // namespace
}  // namespace glissade
