#include "engine/access/plan_access.h"

#include <gtest/gtest.h>

#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

AssemblyStep stepOf(const BodyId& body, const Pose& X_WB, const Vector3& way) {
  AssemblyStep step{{StepMotion()}};
  step.only().body = body;
  Pose end = X_WB;
  end.position += way;
  step.only().path = {{X_WB}, {end}};
  return step;
}

/// A pin in a tube that is too narrow for a hand; the tube can leave.
AssembledProduct pinInTube() {
  RigidBody pin = boxBody("pin", {0.012, 0.012, 0.03}, Pose::translation({0.0, 0.0, 0.016}));
  std::vector<RigidBody> bodies{pin, boxBody("floor", {0.2, 0.2, 0.01}, Pose::translation({0.0, 0.0, -0.005}))};
  for (const double side : {-1.0, 1.0}) {
    bodies.push_back(boxBody(side < 0 ? "x0" : "x1", {0.01, 0.07, 0.2}, Pose::translation({side * 0.03, 0.0, 0.101})));
    bodies.push_back(boxBody(side < 0 ? "y0" : "y1", {0.05, 0.01, 0.2}, Pose::translation({0.0, side * 0.03, 0.101})));
  }
  return test::productOf(std::move(bodies), false);
}

AssemblyPlan planOf(const AssembledProduct& product, const std::vector<BodyId>& order) {
  AssemblyPlan plan;
  for (const RigidBody& body : product.bodies) plan.bodies.push_back(body.id);
  plan.staying = {"floor"};
  for (const BodyId& id : order) {
    plan.steps.push_back(stepOf(id, product.bodies[product.indexOf(id)].X_WB, {0.0, 0.0, 0.5}));
  }
  return plan;
}

TEST(PlanAccess, CountsOnlyWhatIsStillThere) {
  const AssembledProduct product = pinInTube();
  const auto pinFirst = planAccess(product, planOf(product, {"pin", "x0", "x1", "y0", "y1"}), {}, {});
  ASSERT_TRUE(pinFirst.ok());
  EXPECT_EQ(pinFirst->steps[0].hand.access, HandAccess::Blocked);
  EXPECT_EQ(pinFirst->reached(), 4U);
  const auto pinLast = planAccess(product, planOf(product, {"x0", "x1", "y0", "y1", "pin"}), {}, {});
  ASSERT_TRUE(pinLast.ok());
  EXPECT_EQ(pinLast->steps[4].hand.access, HandAccess::Free);
  EXPECT_EQ(pinLast->reached(), 5U);
}

/// The tube leaves with its pin, and is then taken apart: the pin first, or last. The floor is absent then.
TEST(PlanAccess, AsksAboutGroupsThatAreTakenApart) {
  const AssembledProduct product = pinInTube();
  const auto withTube = [&product](const std::vector<BodyId>& order) {
    AssemblyPlan plan = planOf(product, {"pin"});
    plan.steps[0].only().with = {"x0", "x1", "y0", "y1"};
    plan.lines = {{1, plan.steps[0].bodies(), {}, planOf(product, order).steps}};
    return plan;
  };
  const auto pinFirst = planAccess(product, withTube({"pin", "x0", "x1", "y0"}), {}, {});
  ASSERT_TRUE(pinFirst.ok());
  ASSERT_EQ(pinFirst->lines.size(), 1U);
  EXPECT_EQ(pinFirst->lines[0].steps[0].hand.access, HandAccess::Blocked);
  EXPECT_EQ(pinFirst->count(), 5U);
  EXPECT_EQ(pinFirst->reached() + 1, planAccess(product, withTube({"x0", "x1", "y0", "pin"}), {}, {})->reached());
  AssemblyPlan onFloor = withTube({"x0", "x1", "y0", "pin"});
  const Vector3 down(0.0, 0.0, -0.5);
  onFloor.lines[0].steps[3].only().path.back().q.position =
      onFloor.lines[0].steps[3].only().path.front().q.position + down;
  const auto downwards = planAccess(product, onFloor, {}, {});
  ASSERT_TRUE(downwards.ok());
  EXPECT_NE(downwards->lines[0].steps[3].hand.blockedBy, product.indexOf("floor"));
}

TEST(PlanAccess, AToolThatThePlanFoundBlockedIsBlocked) {
  const AssembledProduct product = pinInTube();
  AssemblyPlan plan = planOf(product, {"x0"});
  plan.steps[0].only().tool = {ToolKind::Socket, ToolAccess::Blocked, {"x1"}};
  const auto access = planAccess(product, plan, {}, {});
  ASSERT_TRUE(access.ok());
  EXPECT_EQ(access->steps[0].hand.access, HandAccess::Blocked);
  EXPECT_EQ(access->steps[0].hand.blockedBy, product.indexOf("x1"));
}

TEST(PlanAccess, AnEyeThatAPersonSaysIsTheOnlyOne) {
  const AssembledProduct product = pinInTube();
  const AssemblyPlan plan = planOf(product, {"pin"});
  const Person aside{HandSize::Average, Vector3(1.0, 0.0, 0.05)};
  const auto hidden = planAccess(product, plan, aside, {});
  ASSERT_TRUE(hidden.ok());
  EXPECT_FALSE(hidden->steps[0].sight.isSeen());
  EXPECT_TRUE(hidden->steps[0].sight.blockedBy);
  const auto above = planAccess(product, plan, {}, {});
  ASSERT_TRUE(above.ok());
  EXPECT_TRUE(above->steps[0].sight.isSeen()) << "from above";
}

TEST(PlanAccess, SaysThatItWasStopped) {
  StopSource stop;
  stop.requestStop();
  const AssembledProduct product = pinInTube();
  const auto access = planAccess(product, planOf(product, {"pin"}), {}, {stop.token(), {}});
  ASSERT_FALSE(access.ok());
  EXPECT_EQ(access.error().kind, ErrorKind::Interrupted);
}

TEST(PathAccess, BeginsAtTheEndThatIsNearerToABody) {
  const std::vector<RigidBody> ground{boxBody("ground", {0.3, 0.3, 0.01}, Pose::translation({0.0, 0.0, -0.005}))};
  RigidBody object = boxBody("object", {0.02, 0.02, 0.04}, Pose::identity());
  const Pose place = Pose::translation({0.0, 0.0, 0.0201});
  const Pose away = Pose::translation({0.0, 0.0, 0.4});
  const auto insertion = pathAccess(ground, object, {away, place}, {}, {});
  ASSERT_TRUE(insertion.ok());
  EXPECT_TRUE(insertion->beginsAtEnd);
  EXPECT_EQ(insertion->X_WB, place);
  EXPECT_EQ(insertion->motion.hand.access, HandAccess::Free);
  const auto removal = pathAccess(ground, object, {place, away}, {}, {});
  ASSERT_TRUE(removal.ok());
  EXPECT_FALSE(removal->beginsAtEnd);
  EXPECT_EQ(removal->motion.hand.access, HandAccess::Free);
  const auto still = pathAccess(ground, object, {place}, {}, {});
  ASSERT_TRUE(still.ok());
  EXPECT_EQ(still->motion.hand.access, HandAccess::Free) << "a path of one configuration";
}

}  // namespace
}  // namespace glissade
