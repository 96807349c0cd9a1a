// A screw with a modelled thread in a nut that is drawn with the core diameter: the pair comes apart by turning only,
// and the judge confirms no other motion.
#include <gtest/gtest.h>

#include "engine/base/thread_team.h"
#include "engine/files/judged_product.h"
#include "engine/fits/fit_table.h"
#include "engine/sequence/sequence_run.h"
#include "tests/engine/fits/threaded_screw.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

constexpr double kNutHole = 0.00207;

RigidBody threadedBody(const std::string& id, TriangleMesh mesh) {
  RigidBody body = boxBody(id, {1.0, 1.0, 1.0}, Pose::identity());
  body.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
  return body;
}

/// A nut whose wall is less than five overlaps thick, on the end of the screw.
AssembledProduct screwInNut(const test::ThreadedScrew& screw = {}, double hole = kNutHole) {
  return test::productOf(
      {threadedBody("screw", screw.mesh()), threadedBody("nut", test::plainNut(hole, -0.0075, -0.0035))}, true);
}

FitTable fitsOf(const AssembledProduct& product) {
  ThreadTeam team(0);
  return *FitTable::find(product, team, WorkWatch{});
}

AssemblyPlan planOf(const AssembledProduct& product) {
  test::QuietHost host;
  auto plan = planSequence(product, test::fitsOf(product), SequenceRequest{BodySet{true, false}}, host);
  EXPECT_TRUE(plan.ok());
  return std::move(*plan);
}

bool isConfirmed(const AssemblyPlan& plan, const AssembledProduct& product) {
  return judgePlan(plan, product, std::nullopt, {}).valid();
}

/// The plan, found once for all tests.
const AssemblyPlan& goodPlan() {
  static const AssemblyPlan plan = planOf(screwInNut());
  return plan;
}

class ThreadCorePlan : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(plan.steps.size(), 1U);
    ASSERT_EQ(plan.steps[0].only().allowances.size(), 1U);
    ASSERT_TRUE(allowance().core);
  }
  Allowance& allowance() { return plan.steps[0].only().allowances[0]; }
  std::vector<PathPoint>& path() { return plan.steps[0].only().path; }

  AssembledProduct product = screwInNut();
  AssemblyPlan plan = goodPlan();
};

TEST(ThreadCoreFits, TheScrewIsItsCoreInTheNutWhicheverOfThemMoves) {
  const AssembledProduct product = screwInNut();
  const FitTable table = fitsOf(product);
  ASSERT_EQ(table.pairs().size(), 1U);
  EXPECT_EQ(table.pairs()[0].contact.kind, ContactKind::Thread);
  for (const PairWay& way : table.pairs()[0].ways) {
    ASSERT_EQ(way.taken.size(), 1U) << toString(way.refused);
    const Fit& fit = way.taken[0];
    EXPECT_TRUE(fit.core);
    ASSERT_TRUE(fit.thread);
    EXPECT_NEAR(fit.thread->rule.pitch, 0.0008, 1e-9);
    EXPECT_NEAR(fit.allowance, 0.0025 - kNutHole, 4e-5);
  }
}

/// A screw for plastic: its core is half as thick as its crests, and its hole is wide and deep.
AssembledProduct screwInBoss() {
  const test::ThreadedScrew screw{0.0011, 0.00064, 0.00085, 0.0045};
  return test::productOf({threadedBody("M2x4 self tapping screw", screw.mesh()),
                          threadedBody("boss", test::blockMesh(0.00095, 0.008, 0.006, -0.012, -0.001))},
                         true);
}

TEST(SelfTappingScrew, IsTurnedOutAndTheJudgeRefusesThePull) {
  const AssembledProduct product = screwInBoss();
  test::QuietHost host;
  auto plan = planSequence(product, test::fitsOf(product), SequenceRequest{BodySet{false, true}}, host);
  ASSERT_TRUE(plan.ok());
  ASSERT_EQ(plan->steps.size(), 1U);
  EXPECT_EQ(plan->steps[0].only().method, kTurned);
  ASSERT_EQ(plan->steps[0].only().allowances.size(), 1U);
  EXPECT_TRUE(plan->steps[0].only().allowances[0].core);
  EXPECT_NEAR(plan->steps[0].only().allowances[0].pitch, 0.00085, 0.01 * 0.00085);
  EXPECT_TRUE(isConfirmed(*plan, product));
  // The judge refuses the claim of a left-handed thread, and a straight pull.
  AssemblyPlan leftHanded = *plan;
  leftHanded.steps[0].only().allowances[0].core->pitch *= -1.0;
  leftHanded.steps[0].only().allowances[0].pitch *= -1.0;
  EXPECT_FALSE(isConfirmed(leftHanded, product));
  const Quaternion before = plan->steps[0].only().path.front().q.orientation;
  for (PathPoint& point : plan->steps[0].only().path) point.q.orientation = before;
  EXPECT_FALSE(isConfirmed(*plan, product));
  // The hole that is taken wider instead lets no thread be pulled either.
  Allowance& wider = plan->steps[0].only().allowances[0];
  wider.core.reset();
  wider.yields = true;
  wider.kind = ContactKind::Overlap;
  wider.allowance = 0.00016;
  EXPECT_FALSE(isConfirmed(*plan, product));
}

/// A pin that is too thick for its ring has no helix.
TEST(ThreadCoreFits, WithoutAHelixNoThreadIsTakenAway) {
  const FitTable table = fitsOf(test::productOf({threadedBody("pin", test::rodMesh(0.0025, -0.008, 0.0)),
                                                 threadedBody("ring", test::plainNut(kNutHole, -0.0075, -0.0035))},
                                                true));
  for (const PairFit& pair : table.pairs()) {
    for (const PairWay& way : pair.ways) {
      for (const Fit& fit : way.taken) EXPECT_FALSE(fit.core);
    }
  }
}

TEST_F(ThreadCorePlan, TheNutIsTurnedOffAndTheJudgeConfirmsIt) {
  EXPECT_EQ(plan.steps[0].only().method, kTurned);
  EXPECT_TRUE(isConfirmed(plan, product));
}

TEST_F(ThreadCorePlan, APullWithoutTurningIsRefused) {
  const Quaternion before = path().front().q.orientation;
  for (PathPoint& point : path()) point.q.orientation = before;
  EXPECT_FALSE(isConfirmed(plan, product));
}

TEST_F(ThreadCorePlan, AFalseAxisIsRefused) {
  allowance().core->point += Vector3(5e-5, 0.0, 0.0);
  EXPECT_FALSE(isConfirmed(plan, product));
}

TEST_F(ThreadCorePlan, AFalsePitchIsRefused) {
  allowance().core->pitch *= 1.1;
  allowance().pitch *= 1.1;
  EXPECT_FALSE(isConfirmed(plan, product));
}

TEST_F(ThreadCorePlan, AFalseRadiusOfTheHoleIsRefused) {
  allowance().core->radiusMoving -= 1e-4;
  EXPECT_FALSE(isConfirmed(plan, product));
}

TEST_F(ThreadCorePlan, TheThreadOfTheOtherBodyIsNotTakenAway) {
  allowance().yields = !allowance().yields;
  EXPECT_FALSE(isConfirmed(plan, product));
}

TEST_F(ThreadCorePlan, ALargerAllowanceIsRefused) {
  allowance().allowance *= 1.1;
  EXPECT_FALSE(isConfirmed(plan, product));
}

/// The claim is repeated for the motion of a nut whose hole is narrower than the roots, on a pin, and on a shank.
TEST_F(ThreadCorePlan, ItIsRefusedOfBodiesWithoutThatThread) {
  EXPECT_FALSE(isConfirmed(plan, screwInNut({}, 0.0019)));
  AssembledProduct pin = product;
  pin.bodies[0] = screwInNut().bodies[0];
  TriangleMesh rod = test::rodMesh(0.0025, -0.008, 0.003);
  pin.bodies[0].mesh = std::make_shared<const TriangleMesh>(transformed(rod, inverse(pin.bodies[0].X_WB)));
  EXPECT_FALSE(isConfirmed(plan, pin));
  test::ThreadedScrew shank;
  shank.shank = 0.0062;
  EXPECT_FALSE(isConfirmed(plan, screwInNut(shank)));
}

/// A person's statement has priority over the file's claim.
TEST_F(ThreadCorePlan, ItIsRefusedWhereAPersonSaysThatThePairIsNoThread) {
  product.fits.pairs.push_back({"screw", "nut", ContactKind::Cylindrical, std::nullopt});
  EXPECT_FALSE(isConfirmed(plan, product));
}

}  // namespace
}  // namespace glissade
