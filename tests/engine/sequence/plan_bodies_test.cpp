#include "engine/sequence/plan_bodies.h"

#include <gtest/gtest.h>

#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

/// The product as in a scenario: with other ids, and the first body last.
AssembledProduct renamed(AssembledProduct product) {
  std::rotate(product.bodies.begin(), product.bodies.begin() + 1, product.bodies.end());
  for (RigidBody& body : product.bodies) body.id = BodyId("part." + body.name);
  return product;
}

TEST(PlanBodies, APlanOfTheFileIsAboutTheScenarioThatWasMadeOfIt) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyPlan plan = test::planOf(product, "cabinet");
  plan.stuck.push_back({"drawer", {"pin"}});
  plan.steps[0].only().falling = {"pin"};
  plan.steps[0].only().tool.blockedBy = {"drawer"};
  plan.waiting = plan.steps[1].motions;
  plan.demands.before = {{"cap", "end-of-an-id"}};
  plan.demands.masses = {{"pin", 2.0}};
  plan.demands.attributes["pin"] = {{"price", 1.0}};
  const AssembledProduct ours = renamed(product);
  const auto about = planAbout(ours, plan);
  ASSERT_TRUE(about);
  EXPECT_EQ(test::orderOf(*about), (std::vector<BodyId>{"part.cap", "part.pin", "part.drawer"}));
  EXPECT_EQ(about->staying, std::vector<BodyId>{"part.cabinet"});
  EXPECT_EQ(about->stuck[0].blockedBy, std::vector<BodyId>{"part.pin"});
  EXPECT_EQ(about->steps[0].only().falling, std::vector<BodyId>{"part.pin"});
  EXPECT_EQ(about->steps[0].only().tool.blockedBy, std::vector<BodyId>{"part.drawer"});
  EXPECT_EQ(about->waiting[0].body, "part.pin");
  EXPECT_EQ(about->demands.before[0], (std::pair<std::string, std::string>{"part.cap", "end-of-an-id"}));
  EXPECT_EQ(about->demands.masses[0].first, "part.pin");
  EXPECT_EQ(about->demands.attributes.count("part.pin"), 1U);
  for (std::size_t i = 0; i < ours.bodies.size(); ++i) EXPECT_EQ(about->bodies[i], ours.bodies[i].id);
  for (const AssemblyStep& step : about->steps) {
    EXPECT_TRUE(step.only().proof.nearest.empty() || ours.find(step.only().proof.nearest));
  }
}

TEST(PlanBodies, APlanOfAnotherProductIsNotTaken) {
  const AssemblyPlan plan = test::planOf(test::lockedDrawer(), "cabinet");
  EXPECT_FALSE(planAbout(test::chain(), plan));
  AssembledProduct two = test::lockedDrawer();
  for (RigidBody& body : two.bodies) {
    body.id = BodyId(body.id.text() + ".x");
    body.name = "same";
  }
  EXPECT_FALSE(planAbout(two, plan)) << "names that do not tell bodies apart";
}

TEST(PlanBodies, AllBodiesOfAGroupLeave) {
  const AssembledProduct product = test::lockedDrawer();
  AssemblyStep step{{StepMotion()}};
  step.only().body = "pin";
  step.only().with = {"cap"};
  EXPECT_EQ(bodiesOf(step, product), (std::vector<std::size_t>{product.indexOf("pin"), product.indexOf("cap")}));
}

/// A motion states allowances for all orders. The nut and the washer have left before the bolt.
TEST(PlanBodies, AllowancesInOrderLeaveOutBodiesThatHaveLeft) {
  std::vector<AssemblyStep> steps(2, {{StepMotion()}});
  steps[0].only().body = "nut";
  steps[0].only().with = {"washer"};
  steps[1].only().body = "bolt";
  for (const char* other : {"nut", "plate", "washer"}) {
    for (AssemblyStep& step : steps) step.only().allowances.push_back({BodyId(other)});
  }
  EXPECT_EQ(allowancesInOrder(steps, 0, steps[0].only()).size(), 3U);
  const std::vector<Allowance> there = allowancesInOrder(steps, 1, steps[1].only());
  ASSERT_EQ(there.size(), 1U);
  EXPECT_EQ(there.front().body, "plate");
  steps[0].motions.push_back(steps[1].only());
  EXPECT_EQ(allowancesInOrder(steps, 0, steps[0].motions[1]).size(), 1U) << "of the motions of one step, too";
}

}  // namespace
}  // namespace glissade
