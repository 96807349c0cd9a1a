#include <gtest/gtest.h>

#include "engine/sequence/removal_directions.h"
#include "engine/sequence/sequence_run.h"
#include "engine/sequence/step_motion.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

TEST(ShortSlides, ABoxIsBesideAnotherUntilItIsPastIt) {
  const Box3 box(Vector3(0.0, 0.0, 0.0), Vector3(0.2, 0.2, 0.1));
  const Box3 below(Vector3(-1.0, -1.0, -0.1), Vector3(1.0, 1.0, 0.0));
  const Vector3 up = Vector3::UnitZ();
  const Vector3 right = Vector3::UnitX();
  EXPECT_EQ(lengthBeside(box, {}, {right}), 0.0);
  EXPECT_EQ(lengthBeside(box, {below}, {3.0 * up}), 0.0) << "it is lifted off";
  EXPECT_NEAR(lengthBeside(box, {below}, {3.0 * right}), 1.0, 1e-12);
  EXPECT_NEAR(lengthBeside(box, {below}, {0.3 * right}), 0.3, 1e-12) << "it does not get past it";
  EXPECT_NEAR(lengthBeside(box, {below}, {0.3 * right, 3.0 * up}), 0.3, 1e-12);
}

TEST(ShortSlides, APlugLeavesByTheNearEndOfItsTube) {
  for (const double end : {-1.0, 1.0}) {
    const AssembledProduct product = test::productOf(
        {test::ringBody("tube", 0.01, 0.02, 0.3, 0.0), test::ringBody("plug", 0.0, 0.01, 0.02, 0.14 * end)}, true);
    const ProductFits fits = test::fitsOf(product);
    MotionTrial trial(product, fits, 1);
    const RemovalAnswer answer = trial.tryRemoval({1}, BodySet(2, true), 0, {});
    const auto* removed = std::get_if<Removed>(&answer);
    ASSERT_NE(removed, nullptr);
    EXPECT_GT(end * firstDirection(removed->path.points).z(), 0.999);
  }
}

/// A small slab between a table and a large cover leaves sideways while the cover is there. In the order of the plan
/// the cover leaves first, and the slab is lifted off.
TEST(ShortSlides, APartIsLiftedOffWhereWhatLayOnItHasLeft) {
  const AssembledProduct product =
      test::productOf({boxBody("table", {1.0, 1.0, 0.1}, Pose::identity()),
                       boxBody("slab", {0.2, 0.2, 0.05}, Pose::translation({0.0, 0.0, 0.075})),
                       boxBody("cover", {0.6, 0.6, 0.05}, Pose::translation({0.0, 0.0, 0.125}))},
                      true);
  const ProductFits fits = test::fitsOf(product);
  MotionTrial trial(product, fits, 1);
  const RemovalAnswer covered = trial.tryRemoval({1}, BodySet(3, true), 0, {});
  ASSERT_TRUE(std::holds_alternative<Removed>(covered));
  EXPECT_LT(std::abs(firstDirection(std::get<Removed>(covered).path.points).z()), 0.1);

  test::QuietHost host;
  SequenceRequest request;
  request.staying = {true, false, false};
  const auto plan = planSequence(product, fits, request, host);
  ASSERT_TRUE(plan) << toString(plan.error());
  EXPECT_EQ(test::orderOf(*plan), (std::vector<BodyId>{"cover", "slab"}));
  const StepMotion& slab = plan->steps.back().only();
  EXPECT_GT(firstDirection(slab.path).z(), 0.999);
  EXPECT_TRUE(slab.certified);
  EXPECT_EQ(plan->steps.back().after, std::vector<std::size_t>{1}) << "the cover is in its way";
}

/// A peg in a hole through a table leaves downwards while a cover is on it. In the order of the plan the cover leaves
/// first, and the peg is brought from above.
TEST(ShortSlides, APartIsBroughtFromAboveWhereTheWayIsAsLong) {
  const AssembledProduct product =
      test::productOf({test::bodyOf("table", {{{1.0, 0.45, 0.1}, {0.0, -0.275, 0.0}},
                                              {{1.0, 0.45, 0.1}, {0.0, 0.275, 0.0}},
                                              {{0.45, 1.0, 0.1}, {-0.275, 0.0, 0.0}},
                                              {{0.45, 1.0, 0.1}, {0.275, 0.0, 0.0}}}),
                       boxBody("peg", {0.1, 0.1, 0.1}, Pose::identity()),
                       boxBody("cover", {0.6, 0.6, 0.05}, Pose::translation({0.0, 0.0, 0.075}))},
                      true);
  test::QuietHost host;
  SequenceRequest request;
  request.staying = {true, false, false};
  request.demands.gravity = -Vector3::UnitZ();
  request.demands.before = {{"cover", "peg"}};
  const auto plan = planSequence(product, test::fitsOf(product), request, host);
  ASSERT_TRUE(plan) << toString(plan.error());
  EXPECT_EQ(test::orderOf(*plan), (std::vector<BodyId>{"cover", "peg"}));
  EXPECT_GT(exitDirection(plan->steps.back().only().path).z(), 0.999);
}

}  // namespace
}  // namespace glissade
