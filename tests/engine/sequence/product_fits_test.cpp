#include "engine/sequence/product_fits.h"

#include <gtest/gtest.h>

#include "engine/check/verdict_report.h"
#include "engine/files/judged_product.h"
#include "tests/engine/fits/ring.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

/// A washer and a nut on a bolt with a head, all with the bolt's radius; sizes of M8 in metres.
AssembledProduct boltAndNut() {
  RigidBody bolt = test::ringBody("bolt", 0.0, 0.004, 0.04, 0.0);
  TriangleMesh head = transformed(test::makeRing(0.0, 0.008, 0.006, 24), Pose::translation({0.0, 0.0, -0.022}));
  TriangleMesh mesh = *bolt.mesh;
  append(mesh, head);
  bolt.mesh = std::make_shared<const TriangleMesh>(mesh);
  return test::productOf(
      {bolt, test::ringBody("washer", 0.004, 0.009, 0.002, 0.0), test::ringBody("nut", 0.004, 0.007, 0.006, 0.004)},
      true);
}

TEST(ProductFits, AreThoseOfEachBodyAlone) {
  const AssembledProduct product = boltAndNut();
  const ProductFits fits = test::fitsOf(product);
  for (std::size_t body = 0; body < product.bodies.size(); ++body) {
    const auto alone = findObjectFits({product, body});
    ASSERT_TRUE(alone.ok());
    ASSERT_EQ(alone->allowed.size(), fits.fitsOf(body).size());
    for (std::size_t i = 0; i < alone->allowed.size(); ++i) {
      EXPECT_EQ(alone->allowed[i].obstacle, fits.fitsOf(body)[i].obstacle);
      EXPECT_EQ(alone->allowed[i].allowance, fits.fitsOf(body)[i].allowance);
      EXPECT_EQ(alone->allowed[i].role, fits.fitsOf(body)[i].role);
    }
  }
}

TEST(ProductFits, ThinAgainstTheirOwnAndHaveTheAxis) {
  const AssembledProduct product = boltAndNut();
  const ProductFits fits = test::fitsOf(product);
  EXPECT_NE(fits.meshAgainst(2, 0), product.bodies[2].mesh);
  EXPECT_NE(fits.meshAgainst(2, 1), product.bodies[2].mesh);
  EXPECT_NE(fits.obstacleFor(0, 2), product.bodies[2].mesh) << "the bolt is the larger one";
  ASSERT_EQ(fits.axesOf(2).size(), 1U);
  EXPECT_NEAR(std::abs(fits.axesOf(2)[0].z()), 1.0, 1e-9);
}

TEST(ProductFits, APlanWithFitsIsJudgedValidAndStatesThem) {
  const AssembledProduct product = boltAndNut();
  const AssemblyPlan plan = test::planOf(product, "bolt");
  ASSERT_EQ(test::orderOf(plan), (std::vector<BodyId>{"nut", "washer"}));
  EXPECT_EQ(plan.steps[0].only().allowances.size(), 2U);
  EXPECT_EQ(plan.steps[1].only().allowances.size(), 1U);
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt);
  for (const check::StepVerdict& step : verdict.steps) {
    EXPECT_TRUE(step.valid()) << toString(whyInvalid(step, judgedProduct(product)));
  }
  AssembledProduct strict = product;
  strict.fits.on = false;
  const check::PlanVerdict whole = judgePlan(plan, strict, std::nullopt);
  EXPECT_FALSE(whole.steps[0].certified()) << "the whole nut does not leave";
}

/// A bolt with a wall that is thin compared with the overlap of its thread. The result does not depend on which body
/// moves.
TEST(ProductFits, WhereABodyHasNoPlaceForAnAllowanceTheOtherOneIsTakenThinner) {
  const AssembledProduct product = test::productOf(
      {test::ringBody("bolt", 0.0035, 0.004, 0.04, 0.0), test::ringBody("nut", 0.0039, 0.008, 0.006, 0.0)}, true);
  const ProductFits fits = test::fitsOf(product);
  ASSERT_EQ(fits.fitsOf(0).size(), 1U);
  ASSERT_EQ(fits.fitsOf(1).size(), 1U);
  EXPECT_TRUE(fits.fitsOf(0).front().yields);
  EXPECT_FALSE(fits.fitsOf(1).front().yields);
  EXPECT_EQ(fits.obstacleFor(1, 0), product.bodies[0].mesh);
  EXPECT_TRUE(fits.warnings().empty());
  const AssemblyPlan plan = test::planOf(product, "bolt");
  ASSERT_EQ(test::orderOf(plan), std::vector<BodyId>{"nut"});
  ASSERT_EQ(plan.steps[0].only().allowances.size(), 1U);
  EXPECT_FALSE(plan.steps[0].only().allowances[0].yields);
  const check::StepVerdict step = judgePlan(plan, product, std::nullopt).steps[0];
  EXPECT_TRUE(step.valid()) << toString(whyInvalid(step, judgedProduct(product)));
}

}  // namespace
}  // namespace glissade
