// A person moves a step of a finished plan: the motions stay, and nothing is searched.
#include "engine/sequence/step_order.h"

#include <gtest/gtest.h>

#include "engine/files/judged_product.h"
#include "engine/sequence/demand_edits.h"
#include "engine/sequence/sequence_run.h"
#include "engine/sequence/step_precedence.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

AssembledProduct boxesBesideEachOther() {
  const auto box = [](const char* id, double x) {
    return boxBody(id, Vector3::Constant(0.1), Pose::translation({x, 0.0, 0.0}));
  };
  return test::productOf({boxBody("base", {2.0, 2.0, 0.1}, Pose::translation({0.0, 0.0, -0.2})), box("one", -0.5),
                          box("two", 0.0), box("three", 0.5)});
}

/// A trial of this host would be a search.
class NoSearchHost final : public SequenceHost {
 public:
  const StopToken& stopToken() const override { return stop_; }
  ThreadTeam& team() override { return team_; }
  void asking(const std::vector<BodyGroup>& /*groups*/, int /*effort*/) override { ADD_FAILURE() << "a search"; }
  void stepFound(const AssemblyPlan& /*plan*/) override { ADD_FAILURE() << "a search"; }

 private:
  StopToken stop_;
  ThreadTeam team_{0};
};

std::variant<AssemblyPlan, OrderConflict> moved(const AssemblyPlan& plan, std::size_t from, std::size_t to,
                                                const AssembledProduct& product) {
  NoSearchHost host;
  SequenceRequest request{BodySet(product.bodies.size(), false)};
  for (const BodyId& id : plan.staying) request.staying[product.indexOf(id)] = true;
  request.resumed = &plan;
  request.demands = withStepMoved(from, to, plan, plan.demands);
  const auto answer =
      planWithOrder(product, test::fitsOf(product), request, orderWithStepMoved(from, to, plan, plan.demands), host);
  EXPECT_TRUE(answer) << toString(answer.error());
  return *answer;
}

AssemblyPlan planned(const AssembledProduct& product, const BodyId& staying) {
  test::QuietHost host;
  SequenceRequest request{BodySet(product.bodies.size(), false)};
  request.staying[product.indexOf(staying)] = true;
  request.demands.jointUse = JointUse::Off;
  auto plan = planSequence(product, test::fitsOf(product), request, host);
  EXPECT_TRUE(plan.ok());
  return std::move(*plan);
}

TEST(StepOrder, AStepIsMovedWithItsMotionAndThePlanIsStillCertified) {
  const AssembledProduct product = boxesBesideEachOther();
  const AssemblyPlan plan = planned(product, "base");
  const std::vector<BodyId> before = test::orderOf(plan);
  ASSERT_EQ(before.size(), 3U);
  const auto answer = moved(plan, 2, 0, product);
  const auto* after = std::get_if<AssemblyPlan>(&answer);
  ASSERT_NE(after, nullptr) << toString(std::get<OrderConflict>(answer).reason);
  EXPECT_EQ(test::orderOf(*after), (std::vector<BodyId>{before[2], before[0], before[1]}));
  EXPECT_EQ(after->steps[0].only().path.back().q, plan.steps[2].only().path.back().q);
  EXPECT_EQ(after->demands.places.front().place, 1U);
  EXPECT_TRUE(judgePlan(*after, product, std::nullopt).valid());
}

TEST(StepOrder, AStepThatIsInTheWayIsNamed) {
  const AssembledProduct product = test::lockedDrawer();
  const AssemblyPlan plan = planned(product, "cabinet");
  ASSERT_EQ(test::orderOf(plan), (std::vector<BodyId>{"cap", "pin", "drawer"}));
  const auto answer = moved(plan, 1, 0, product);
  const auto* conflict = std::get_if<OrderConflict>(&answer);
  ASSERT_NE(conflict, nullptr);
  EXPECT_EQ(conflict->first, 0U);
  EXPECT_EQ(conflict->then, 1U);
  EXPECT_EQ(toString(conflict->reason), "'cap' is in the way of 'pin'");
}

/// A plan that was stopped knows no order: it demands all earlier steps.
TEST(StepOrder, OnlyAReasonKeepsTheOrder) {
  const AssembledProduct product = boxesBesideEachOther();
  AssemblyPlan plan = planned(product, "base");
  demandAllEarlier(plan);
  const auto answer = moved(plan, 1, 0, product);
  const auto* after = std::get_if<AssemblyPlan>(&answer);
  ASSERT_NE(after, nullptr);
  EXPECT_TRUE(judgePlan(*after, product, std::nullopt).valid());
}

TEST(StepOrder, AMotionThatWouldEndAmongOtherBodiesBecomesLonger) {
  const AssembledProduct product = boxesBesideEachOther();
  AssemblyPlan plan = planned(product, "base");
  std::vector<PathPoint>& path = plan.steps[2].only().path;
  path.back().q.position = path.front().q.position + 1e-3 * (path.back().q.position - path.front().q.position);
  const auto answer = moved(plan, 2, 0, product);
  const auto* after = std::get_if<AssemblyPlan>(&answer);
  ASSERT_NE(after, nullptr) << toString(std::get<OrderConflict>(answer).reason);
  EXPECT_TRUE(judgePlan(*after, product, std::nullopt).valid());
}

TEST(StepOrder, AConstraintKeepsTheOrder) {
  const AssembledProduct product = boxesBesideEachOther();
  AssemblyPlan plan = planned(product, "base");
  const std::vector<BodyId> order = test::orderOf(plan);
  plan.steps[1].after = {1};
  plan.demands.before = {{order[0].text(), order[1].text()}};
  const auto answer = moved(plan, 0, 1, product);
  const auto* conflict = std::get_if<OrderConflict>(&answer);
  ASSERT_NE(conflict, nullptr);
  EXPECT_EQ(toString(conflict->reason),
            "a constraint states that '" + order[0].text() + "' is removed before '" + order[1].text() + "'");
}

}  // namespace
}  // namespace glissade
