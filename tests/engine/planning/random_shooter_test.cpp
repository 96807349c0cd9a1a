#include "engine/planning/random_shooter.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

TEST(RandomShooter, StaysInTheBoundsAndFillsThem) {
  const Box3 bounds(Vector3(-1, 0, 5), Vector3(3, 0.5, 6));
  RandomShooter shooter(bounds, 1);
  Box3 seen;
  Eigen::Vector4d meanAbs = Eigen::Vector4d::Zero();
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const Pose q = shooter.shoot();
    ASSERT_TRUE(bounds.contains(q.position));
    ASSERT_NEAR(q.orientation.norm(), 1.0, 1e-12);
    seen.extend(q.position);
    meanAbs += q.orientation.coeffs().cwiseAbs();
  }
  EXPECT_GT(seen.volume(), 0.99 * bounds.volume());
  // Uniform on the sphere S3: every coordinate has the mean absolute value 4 / (3 pi).
  meanAbs /= kCount;
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(meanAbs[i], 0.42441, 0.01);
}

TEST(RandomShooter, SameSeedSameShots) {
  const Box3 bounds(Vector3::Zero(), Vector3::Ones());
  RandomShooter a(bounds, 5);
  RandomShooter b(bounds, 5);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(a.shoot(), b.shoot());
}

}  // namespace
}  // namespace glissade
