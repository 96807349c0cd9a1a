#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/files/judged_product.h"
#include "engine/files/plan_file.h"
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
  request.staying.assign(product.bodies.size(), false);
  request.staying[0] = true;
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

/// A block in a closed room below the table stays. Searches that found no motion of it name numbers of steps; the plan
/// is read back.
TEST(FloatingUnits, APlanWithAStuckPartIsSavedAndRead) {
  AssembledProduct product = motorInATub();
  product.bodies[0] = test::bodyOf("table", {{{1.0, 1.0, 0.1}, {0.0, 0.0, -0.05}},
                                             {{0.2, 0.2, 0.02}, {-0.3, -0.3, -0.29}},
                                             {{0.02, 0.2, 0.25}, {-0.39, -0.3, -0.2}},
                                             {{0.02, 0.2, 0.25}, {-0.21, -0.3, -0.2}},
                                             {{0.2, 0.02, 0.25}, {-0.3, -0.39, -0.2}},
                                             {{0.2, 0.02, 0.25}, {-0.3, -0.21, -0.2}}});
  product.bodies.push_back(boxBody("block", {0.05, 0.05, 0.05}, Pose::translation({-0.3, -0.3, -0.25})));
  const auto plan = onATable(test::productOf(product.bodies, true));
  ASSERT_TRUE(plan) << toString(plan.error());
  ASSERT_EQ(plan->steps.size(), 2U);
  ASSERT_EQ(plan->stuck.size(), 1U);
  EXPECT_EQ(plan->stuck[0].body, "block");
  const auto read = parsePlan(planJson(*plan, "product.step").dump(), "plan.json");
  EXPECT_TRUE(read) << toString(read.error());
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
