#include "engine/sequence/led_part.h"

#include <gtest/gtest.h>

#include <memory>

#include "engine/geometry/primitives.h"

namespace glissade {
namespace {

/// A part that leaves upwards by 2 m, and then sideways by 1 m.
class LedPartTest : public testing::Test {
 protected:
  static Pose place(double x, double z) { return Pose::translation({x, 0.0, z}); }
  static LedPart make() {
    StepMotion motion;
    for (const Pose& q : {place(0.0, 0.0), place(0.0, 2.0), place(1.0, 2.0)}) motion.path.push_back({q});
    RigidBody body;
    body.mesh = std::make_shared<const TriangleMesh>(makeBox(Vector3::Constant(0.1)));
    return LedPart(StepWay(motion, body), Pose::identity());
  }
  Vector3 position() const { return part_.X_WB().position; }

  LedPart part_ = make();
};

TEST_F(LedPartTest, AtFirstItIsWhereItsMotionEnds) {
  EXPECT_LT((position() - Vector3(1.0, 0.0, 2.0)).norm(), 1e-9);
  EXPECT_FALSE(part_.isAssembled());
}

TEST_F(LedPartTest, ItGoesAlongItsMotionAsFarAsTheHandDoes) {
  part_.lead(place(0.5, 2.3));
  EXPECT_NEAR(position().x(), 0.5, 0.01);
  EXPECT_NEAR(position().z(), 2.0, 1e-9) << "it stays on it";
  part_.lead(place(0.9, 2.3));
  EXPECT_NEAR(position().x(), 0.9, 0.01) << "and back";
}

TEST_F(LedPartTest, AHandThatTakesAShortCutDoesNotAssembleIt) {
  part_.lead(place(0.9, 0.0));
  EXPECT_FALSE(part_.isAssembled());
  EXPECT_NEAR(position().z(), 2.0, 1e-9);
}

TEST_F(LedPartTest, NearTheEndItSnapsAndStays) {
  part_.lead(place(0.0, 2.0));
  part_.lead(place(0.0, 0.2));
  EXPECT_FALSE(part_.isAssembled());
  part_.lead(place(0.0, 0.05));
  EXPECT_TRUE(part_.isAssembled());
  EXPECT_EQ(part_.X_WB(), Pose::identity());
  part_.lead(place(0.0, 1.0));
  EXPECT_TRUE(part_.isAssembled());
}

TEST_F(LedPartTest, AFastHandIsFollowedAtOnce) {
  part_.lead(place(0.0, 2.0));
  part_.lead(place(0.0, 0.0));
  EXPECT_TRUE(part_.isAssembled());
}

}  // namespace
}  // namespace glissade
