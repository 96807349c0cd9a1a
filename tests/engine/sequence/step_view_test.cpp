#include "engine/sequence/step_view.h"

#include <gtest/gtest.h>

#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

AssemblyStep stepAlong(const AssembledProduct& product, const BodyId& body, const Vector3& direction) {
  const Pose& start = product.bodies[product.indexOf(body)].X_WB;
  AssemblyStep step{{StepMotion()}};
  step.only().body = body;
  step.only().path = {{start, Author::Computer}, {{start.position + direction, start.orientation}, Author::Computer}};
  return step;
}

/// A small box on one side of a large wall.
AssembledProduct behindAWall(double side) {
  return test::productOf({boxBody("wall", {0.1, 20.0, 20.0}, Pose::identity()),
                          boxBody("box", {0.5, 0.5, 0.5}, Pose::translation({side, 0.0, 0.0}))});
}

Viewpoint chosen(const AssembledProduct& product, const Vector3& direction, const BodySet& present,
                 const Viewpoint& before = {}) {
  return StepView(product).choose({stepAlong(product, "box", direction)}, present, before);
}

TEST(StepView, LooksFromTheSideWhereThePartIs) {
  for (const double side : {-1.0, 1.0}) {
    const Viewpoint from = chosen(behindAWall(side), Vector3::UnitZ(), BodySet(2, true));
    EXPECT_GT(side * from.toEye().x(), 0.1);
    EXPECT_NEAR(from.toEye().norm(), 1.0, 1e-12);
    EXPECT_FALSE(from.turnedOver);
  }
}

TEST(StepView, ABodyThatIsNotThereHidesNothing) {
  EXPECT_EQ(chosen(behindAWall(1.0), Vector3::UnitZ(), {false, true}), Viewpoint()) << "the one before";
}

TEST(StepView, TheViewpointStaysWhereThePartIsSeen) {
  const AssembledProduct product = behindAWall(-1.0);
  for (const int quarter : {0, 3}) {
    const Viewpoint before{quarter, false};
    EXPECT_EQ(chosen(product, Vector3::UnitZ(), BodySet(2, true), before), before) << quarter;
  }
  EXPECT_NE(chosen(product, Vector3::UnitZ(), BodySet(2, true), {1, false}), (Viewpoint{1, false}));
}

TEST(StepView, TheProductIsTurnedOverWhereOnlyThatShowsThePart) {
  const AssembledProduct product =
      test::productOf({boxBody("table", {20.0, 20.0, 0.1}, Pose::identity()),
                       boxBody("box", {0.5, 0.5, 0.5}, Pose::translation({0.0, 0.0, -1.0}))});
  const Viewpoint from = chosen(product, -Vector3::UnitZ(), BodySet(2, true));
  EXPECT_EQ(from, (Viewpoint{0, true})) << "turned over, and no more";
  EXPECT_LT(from.toEye().z(), 0.0);
  EXPECT_LT(from.up().z(), 0.0);
}

TEST(StepView, ATurnedProductGoesBackOnItsBaseWhereThePartIsSeenSo) {
  const AssembledProduct product = behindAWall(-1.0);
  EXPECT_EQ(chosen(product, Vector3::UnitX(), BodySet(2, true), {0, true}).turnedOver, false);
  const Viewpoint upright{0, false};
  EXPECT_EQ(chosen(product, Vector3::UnitX(), BodySet(2, true), upright), upright);
}

TEST(StepView, ViewsTurnAboutTheUpwardDirectionOfTheWork) {
  for (const Vector3& up : {Vector3(0.0, 1.0, 0.0), Vector3(-1.0, 0.0, 0.0), Vector3(0.6, 0.0, 0.8)}) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      const Viewpoint from{quarter, false, up};
      EXPECT_NEAR(from.toEye().dot(up), Viewpoint{quarter}.toEye().z(), 1e-12) << "the eye is as high above the bench";
      EXPECT_TRUE(from.up().isApprox(up));
      EXPECT_NEAR((Viewpoint{quarter, true, up}).up().dot(up), -1.0, 1e-12);
    }
  }
}

TEST(StepView, TheEyeGoesToWhereThePartIsSeenAndStaysWhereItIs) {
  const AssembledProduct product =
      test::productOf({boxBody("plate", {20.0, 20.0, 0.1}, Pose::identity()),
                       boxBody("box", {0.5, 0.5, 0.5}, Pose::translation({0.0, 0.0, -1.0}))});
  const AssemblyStep step = stepAlong(product, "box", -Vector3::UnitZ());
  StepView view(product);
  const auto below = view.betterEye(step, BodySet(2, true), Vector3(1.0, 1.0, 1.0).normalized());
  ASSERT_TRUE(below);
  EXPECT_LT(below->z(), 0.0);
  EXPECT_GT(view.shareSeen(1, BodySet(2, true), *below), 0.9);
  EXPECT_FALSE(view.betterEye(step, BodySet(2, true), *below));
  EXPECT_FALSE(view.betterEye(step, {false, true}, Vector3(1.0, 1.0, 1.0).normalized())) << "nothing hides it";
}

}  // namespace
}  // namespace glissade
