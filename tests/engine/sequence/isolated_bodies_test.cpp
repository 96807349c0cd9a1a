#include <gtest/gtest.h>

#include "engine/sequence/isolated_bodies.h"
#include "engine/sequence/sequence_run.h"
#include "engine/sequence/work_position.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

/// Two blocks on a plate, and a larger block beside them that touches nothing.
AssembledProduct blocksAndOneBeside() {
  return test::productOf({boxBody("low", {0.1, 0.1, 0.1}, Pose::translation({-0.2, 0.0, 0.1})),
                          boxBody("plate", {1.0, 1.0, 0.1}, Pose::translation({0.0, 0.0, 0.0})),
                          boxBody("beside", {0.4, 0.4, 0.9}, Pose::translation({1.0, 0.0, 0.5})),
                          boxBody("high", {0.1, 0.1, 0.1}, Pose::translation({-0.2, 0.0, 0.2}))},
                         true);
}

Result<AssemblyPlan> planned(const AssembledProduct& product) {
  test::QuietHost host;
  SequenceRequest request;
  request.staying.assign(product.bodies.size(), false);
  return planSequence(product, test::fitsOf(product), request, host);
}

TEST(IsolatedBodies, LeaveFirstAndAreNamed) {
  const auto plan = planned(blocksAndOneBeside());
  ASSERT_TRUE(plan) << toString(plan.error());
  EXPECT_EQ(plan->isolated, std::vector<BodyId>{"beside"});
  EXPECT_EQ(plan->staying, std::vector<BodyId>{"plate"});
  ASSERT_EQ(plan->steps.size(), 3U);
  EXPECT_EQ(plan->steps.front().bodies(), std::vector<BodyId>{"beside"}) << "it comes last when the product is built";
}

TEST(IsolatedBodies, AreNoBaseEvenIfAllOthersAreFasteners) {
  const AssembledProduct product = blocksAndOneBeside();
  const LiaisonGraph graph(4, test::fitsOf(product).contacts(), {});
  EXPECT_EQ(isolatedBodies(product, graph), BodyGroup{2});
  std::vector<FastenerKind> kinds(4, FastenerKind::Washer);
  kinds[2] = FastenerKind::None;
  EXPECT_EQ(workPosition({product, graph, {}, kinds, BodySet(4, true)}).base, 1U);
}

TEST(IsolatedBodies, AreNotKnownWithoutContacts) {
  const AssembledProduct product = blocksAndOneBeside();
  EXPECT_TRUE(isolatedBodies(product, LiaisonGraph(4, {}, {})).empty());
}

TEST(IsolatedBodies, AreNoPartsThatAreDrawnWithPlay) {
  AssembledProduct product = blocksAndOneBeside();
  const LiaisonGraph graph(4, test::fitsOf(product).contacts(), {});
  product.bodies[2].X_WB.position.x() = 0.701;  // 1 mm beside the plate
  EXPECT_TRUE(isolatedBodies(product, graph).empty());
}

}  // namespace
}  // namespace glissade
