#include "engine/sequence/step_view.h"

#include <gtest/gtest.h>

#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

AssemblyStep stepAlong(const AssembledProduct& product, const std::string& body, const Vector3& direction) {
  const Pose& start = product.bodies[*product.indexOf(body)].X_WB;
  AssemblyStep step;
  step.body = body;
  step.path = {{start, Author::Computer}, {{start.position + direction, start.orientation}, Author::Computer}};
  return step;
}

/// A small box on one side of a large wall.
AssembledProduct behindAWall(double side) {
  return test::productOf({boxBody("wall", {0.1, 20.0, 20.0}, Pose::identity()),
                          boxBody("box", {0.5, 0.5, 0.5}, Pose::translation({side, 0.0, 0.0}))});
}

TEST(StepView, LooksFromTheSideWhereThePartIs) {
  for (const double side : {-1.0, 1.0}) {
    const AssembledProduct product = behindAWall(side);
    const Vector3 toEye =
        StepView(product).directionToEye(stepAlong(product, "box", Vector3::UnitZ()), BodySet(2, true));
    EXPECT_GT(side * toEye.x(), 0.1);
    EXPECT_NEAR(toEye.norm(), 1.0, 1e-12);
  }
}

TEST(StepView, ABodyThatHasLeftHidesNothing) {
  const AssembledProduct product = behindAWall(1.0);
  const AssemblyStep step = stepAlong(product, "box", Vector3::UnitZ());
  StepView view(product);
  EXPECT_GT(view.directionToEye(step, {true, true}).x(), 0.0);
  EXPECT_LT(view.directionToEye(step, {false, true}).x(), 0.0) << "the usual direction";
}

TEST(StepView, LooksFromBelowWhereOnlyThatShowsThePart) {
  const AssembledProduct product =
      test::productOf({boxBody("table", {20.0, 20.0, 0.1}, Pose::identity()),
                       boxBody("box", {0.5, 0.5, 0.5}, Pose::translation({0.0, 0.0, -1.0}))});
  EXPECT_LT(StepView(product).directionToEye(stepAlong(product, "box", -Vector3::UnitZ()), BodySet(2, true)).z(), 0.0);
}

}  // namespace
}  // namespace glissade
