#include <gtest/gtest.h>

#include "engine/files/judged_product.h"
#include "engine/sequence/sequence_run.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

/// A table with a column on it. A motor sits in a tub that is open above, 1 mm above the table, and hangs with its
/// flange on the column. Nothing but the motor holds the tub.
AssembledProduct motorInATub() {
  return test::productOf(
      {boxBody("table", {1.0, 1.0, 0.1}, Pose::translation({0.0, 0.0, -0.05})),
       boxBody("column", {0.1, 0.1, 0.3}, Pose::translation({0.3, 0.0, 0.15})),
       test::bodyOf("tub", {{{0.2, 0.2, 0.02}, {0.0, 0.0, 0.011}},
                            {{0.02, 0.2, 0.2}, {-0.09, 0.0, 0.101}},
                            {{0.02, 0.2, 0.2}, {0.09, 0.0, 0.101}},
                            {{0.2, 0.02, 0.2}, {0.0, -0.09, 0.101}},
                            {{0.2, 0.02, 0.2}, {0.0, 0.09, 0.101}}}),
       test::bodyOf("motor", {{{0.16, 0.16, 0.31}, {0.0, 0.0, 0.176}}, {{0.4, 0.1, 0.031}, {0.15, 0.0, 0.3155}}})},
      true);
}

Result<AssemblyPlan> onATable(const AssembledProduct& product) {
  test::QuietHost host;
  SequenceRequest request;
  request.staying = {true, false, false, false};
  return planSequence(product, test::fitsOf(product), request, host);
}

TEST(FloatingUnits, WhatHangsOnAPartComesTogetherWithIt) {
  const AssembledProduct product = motorInATub();
  const auto plan = onATable(product);
  ASSERT_TRUE(plan) << toString(plan.error());
  ASSERT_EQ(plan->steps.size(), 2U);
  EXPECT_EQ(plan->steps[0].only().bodies(), (std::vector<BodyId>{"tub", "motor"}));
  EXPECT_EQ(plan->steps[1].only().body, "column");
  ASSERT_EQ(plan->lines.size(), 1U) << "the unit is built on the bench";
  EXPECT_EQ(plan->lines[0].steps.size(), 1U);
  EXPECT_TRUE(plan->lines[0].stuck.empty());
  EXPECT_TRUE(judgePlan(*plan, product, std::nullopt, {}).valid());
}

/// A part that can leave alone while its carrier is there leaves before it.
TEST(FloatingUnits, APartLeavesBeforeWhatItStandsOn) {
  const AssembledProduct product =
      test::productOf({boxBody("table", {1.0, 1.0, 0.1}, Pose::translation({0.0, 0.0, -0.05})),
                       boxBody("block", {0.2, 0.2, 0.2}, Pose::translation({0.0, 0.0, 0.1})),
                       boxBody("lamp", {0.6, 0.6, 0.2}, Pose::translation({0.0, 0.0, 0.3})),
                       boxBody("cap", {0.1, 0.1, 0.1}, Pose::translation({0.0, 0.0, 0.45}))},
                      true);
  const auto plan = onATable(product);
  ASSERT_TRUE(plan) << toString(plan.error());
  EXPECT_EQ(test::orderOf(*plan), (std::vector<BodyId>{"cap", "lamp", "block"}));
}

}  // namespace
}  // namespace glissade
