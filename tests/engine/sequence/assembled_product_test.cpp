#include <gtest/gtest.h>

#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

TEST(AssembledProduct, FramesAreInTheMiddleAndMeshesStayShared) {
  const auto mesh =
      std::make_shared<const TriangleMesh>(transformed(makeBox({1.0, 2.0, 3.0}), Pose::translation({5.0, 0.0, 0.0})));
  const Pose turned{{1.0, 2.0, 3.0}, fromRollPitchYaw(0.3, 0.2, 0.1)};
  const std::vector<RigidBody> before{{"a", "a", Mobility::Static, mesh, Pose::identity()},
                                      {"b", "b", Mobility::Static, mesh, turned}};
  const auto after = aboutTheirMiddles(before);
  EXPECT_EQ(after[0].mesh, after[1].mesh);
  EXPECT_LT(boundingBox(*after[0].mesh).center().norm(), 1e-12);
  for (std::size_t body = 0; body < before.size(); ++body) {
    for (std::size_t i = 0; i < mesh->vertices.size(); ++i) {
      const Vector3 moved = after[body].X_WB * after[body].mesh->vertices[i] - before[body].X_WB * mesh->vertices[i];
      EXPECT_LT(moved.norm(), 1e-12);
    }
  }
}

TEST(AssembledProduct, TheLargestIsByItsBox) {
  const AssembledProduct product = test::lockedDrawer();
  EXPECT_EQ(product.bodies[largestBody(product)].id, "cabinet");
  EXPECT_EQ(product.find("pin"), 2U);
  EXPECT_FALSE(product.find("key"));
}

}  // namespace
}  // namespace glissade
