#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/random_stream.h"
#include "engine/files/judged_product.h"
#include "engine/planning/path_certificate.h"
#include "engine/sequence/motion_world.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

std::size_t bodyNamed(const AssembledProduct& product, const BodyId& id) { return product.indexOf(id); }

TEST(MotionTrial, ADrawerLeavesWhenItsPinHas) {
  const AssembledProduct product = test::lockedDrawer();
  const ProductFits fits = test::fitsOf(product);
  MotionTrial trial(product, fits, 1);
  BodySet present(4, true);
  const auto drawer = bodyNamed(product, "drawer");
  const auto pin = bodyNamed(product, "pin");
  const auto cap = bodyNamed(product, "cap");
  const RemovalAnswer locked = trial.tryRemoval({drawer}, present, 0, {});
  ASSERT_TRUE(std::holds_alternative<Refused>(locked));
  const auto& blocking = std::get<Refused>(locked).blockedBy;
  EXPECT_NE(std::find(blocking.begin(), blocking.end(), pin), blocking.end());
  EXPECT_TRUE(std::holds_alternative<Refused>(trial.tryRemoval({pin}, present, 0, {})));
  present[cap] = present[pin] = false;
  const RemovalAnswer open = trial.tryRemoval({drawer}, present, 0, {});
  ASSERT_TRUE(std::holds_alternative<Removed>(open));
  const auto& path = std::get<Removed>(open).path;
  EXPECT_EQ(path.certificate.status, CertificateStatus::Certified);
  EXPECT_GT(path.points.back().q.position.x(), 0.7);
}

TEST(MotionTrial, AnAnswerDoesNotDependOnWhatWasAskedBefore) {
  const AssembledProduct product = test::lockedDrawer();
  const ProductFits fits = test::fitsOf(product);
  RandomStream random(3, "questions");
  MotionTrial asked(product, fits, 1);
  for (int question = 0; question < 40; ++question) {
    const auto body = static_cast<std::size_t>(random.uniform(0.0, 4.0));
    BodySet present(4);
    for (std::size_t other = 0; other < 4; ++other) present[other] = other == body || random.uniform() < 0.6;
    MotionTrial fresh(product, fits, 1);
    const RemovalAnswer one = asked.tryRemoval({body}, present, 0, {});
    const RemovalAnswer other = fresh.tryRemoval({body}, present, 0, {});
    ASSERT_EQ(one.index(), other.index());
    if (const auto* removed = std::get_if<Removed>(&one)) {
      EXPECT_EQ(removed->path.points.back().q, std::get<Removed>(other).path.points.back().q);
    }
  }
}

/// A peg in a blind hole of a frame, with a roof over it.
AssembledProduct pegUnderARoof() {
  const RigidBody frame = test::bodyOf("frame", {{{1.0, 0.44, 0.2}, {0.0, -0.28, 0.0}},
                                                 {{1.0, 0.44, 0.2}, {0.0, 0.28, 0.0}},
                                                 {{0.44, 1.0, 0.2}, {-0.28, 0.0, 0.0}},
                                                 {{0.44, 1.0, 0.2}, {0.28, 0.0, 0.0}},
                                                 {{1.0, 1.0, 0.1}, {0.0, 0.0, -0.15}},
                                                 {{0.1, 1.0, 1.0}, {-0.45, 0.0, 0.4}},
                                                 {{1.0, 1.0, 0.1}, {0.0, 0.0, 0.85}}});
  return test::productOf({frame, boxBody("peg", {0.1, 0.1, 0.3}, Pose::translation({0.0, 0.0, 0.06}))});
}

TEST(MotionTrial, APegLeavesAlongTwoLines) {
  const AssembledProduct product = pegUnderARoof();
  const ProductFits fits = test::fitsOf(product);
  MotionTrial trial(product, fits, 1);
  const BodyGroup peg{bodyNamed(product, "peg")};
  EXPECT_TRUE(std::holds_alternative<Refused>(trial.tryRemoval(peg, BodySet(2, true), 0, {})));
  const RemovalAnswer answer = trial.tryRemoval(peg, BodySet(2, true), 1, {});
  ASSERT_TRUE(std::holds_alternative<Removed>(answer));
  const Removed& removed = std::get<Removed>(answer);
  EXPECT_EQ(removed.method, kTwoLines);
  ASSERT_EQ(removed.path.points.size(), 3U);
  EXPECT_EQ(removed.path.certificate.status, CertificateStatus::Certified);
  const Vector3 up = removed.path.points[1].q.position - removed.path.points[0].q.position;
  EXPECT_NEAR(up.z(), 0.3, 1e-9) << "as far as the peg is long";
}

/// A forbidden direction also holds for the second line.
TEST(MotionTrial, TwoLinesKeepToForbiddenDirections) {
  const AssembledProduct product = pegUnderARoof();
  const ProductFits fits = test::fitsOf(product);
  const BodyGroup peg{bodyNamed(product, "peg")};
  std::vector<std::vector<Vector3>> forbidden(2);
  for (const double x : {-1.0, 1.0}) {
    forbidden[peg.front()].push_back(Vector3(x, 0.0, 0.0));
    forbidden[peg.front()].push_back(Vector3(0.0, x, 0.0));
  }
  MotionTrial trial(product, fits, 1, 1, forbidden);
  const RemovalAnswer answer = trial.tryRemoval(peg, BodySet(2, true), 1, {});
  const auto* removed = std::get_if<Removed>(&answer);
  EXPECT_TRUE(removed == nullptr || removed->method != kTwoLines);
}

/// A proof against bodies holds after some of them have left.
TEST(MotionTrial, MotionsHoldForEverySubset) {
  const AssembledProduct product = test::lockedDrawer();
  const ProductFits fits = test::fitsOf(product);
  MotionWorlds worlds(product, fits);
  const AssemblyPlan plan = test::planOf(product, "cabinet");
  BodySet present(4, true);
  for (const AssemblyStep& step : plan.steps) {
    const std::size_t body = bodyNamed(product, step.only().body);
    present[body] = false;
    for (unsigned mask = 0; mask < 16; ++mask) {
      BodySet subset = present;
      for (std::size_t other = 0; other < 4; ++other) subset[other] = subset[other] && (mask >> other & 1U) != 0;
      const auto motion = worlds.world({body}, subset);
      const auto certificate = certifyPath(*motion.world->makeQuery(), step.only().path, worlds.parameters({body}));
      EXPECT_EQ(certificate.status, CertificateStatus::Certified) << step.only().body << ", bodies " << mask;
    }
  }
}

TEST(MotionTrial, ComposedWorldsAnswerAsThoseBuiltAtOnce) {
  const AssembledProduct product = test::lockedDrawer();
  const ProductFits fits = test::fitsOf(product);
  MotionWorlds worlds(product, fits);
  RandomStream random(4, "poses");
  for (std::size_t body = 0; body < 4; ++body) {
    BodySet others(4, true);
    const auto motion = worlds.world({body}, others);
    std::vector<RigidBody> obstacles = product.bodies;
    obstacles.erase(obstacles.begin() + static_cast<std::ptrdiff_t>(body));
    const auto built = CollisionWorld::build(obstacles, product.bodies[body].mesh);
    const auto one = motion.world->makeQuery();
    const auto other = built->makeQuery();
    EXPECT_EQ(motion.world->objectRadius(), built->objectRadius());
    for (int i = 0; i < 300; ++i) {
      Pose q{Vector3(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)),
             fromRollPitchYaw(random.uniform(-3.0, 3.0), random.uniform(-1.5, 1.5), random.uniform(-3.0, 3.0))};
      EXPECT_EQ(one->collidingBody(q), other->collidingBody(q));
      // Composed worlds are queried in the frames of the meshes, which round differently.
      EXPECT_NEAR(one->nearestObstacle(q).distance, other->nearestObstacle(q).distance, 1e-14);
      EXPECT_EQ(one->clearAbove(q, 0.1), other->clearAbove(q, 0.1));
    }
  }
}

/// A tongue in a slot, both in a tray that is open at the top.
AssembledProduct tongueInTray() {
  return test::productOf({test::bodyOf("tray", {{{1.6, 1.6, 0.1}, {0.0, 0.0, -0.45}},
                                                {{0.1, 1.6, 0.8}, {-0.75, 0.0, -0.1}},
                                                {{0.1, 1.6, 0.8}, {0.75, 0.0, -0.1}},
                                                {{1.6, 0.1, 0.8}, {0.0, -0.75, -0.1}},
                                                {{1.6, 0.1, 0.8}, {0.0, 0.75, -0.1}}}),
                          test::bodyOf("slot", {{{0.1, 1.36, 0.6}, {-0.6, 0.0, -0.05}},
                                                {{0.6, 1.36, 0.1}, {-0.35, 0.0, 0.2}},
                                                {{0.6, 1.36, 0.1}, {-0.35, 0.0, -0.3}},
                                                {{0.1, 1.36, 0.15}, {-0.1, 0.0, 0.1}},
                                                {{0.1, 1.36, 0.15}, {-0.1, 0.0, -0.2}}}),
                          test::bodyOf("tongue", {{{0.1, 1.36, 0.36}, {-0.25, 0.0, -0.05}},
                                                  {{0.6, 1.36, 0.08}, {0.0, 0.0, -0.05}},
                                                  {{0.4, 1.36, 0.6}, {0.3, 0.0, -0.05}}}),
                          boxBody("lamp", Vector3::Constant(0.2), Pose::translation({3.0, 0.0, 0.0}))});
}

TEST(MotionTrial, AGroupLeavesWhereNoneOfItsBodiesDoes) {
  const AssembledProduct product = tongueInTray();
  const AssemblyPlan plan = test::planOf(product, "tray");
  EXPECT_EQ(plan.end, PlanEnd::Complete);
  ASSERT_EQ(plan.steps.size(), 2U);
  EXPECT_EQ(plan.steps[0].bodies(), std::vector<BodyId>{"lamp"});
  EXPECT_EQ(plan.steps[1].bodies(), (std::vector<BodyId>{"slot", "tongue"}));
  EXPECT_EQ(plan.removed(), 3U);
  EXPECT_GT(plan.steps[1].only().path.back().q.position.z(), plan.steps[1].only().path.front().q.position.z() + 0.5);
  const check::PlanVerdict verdict = judgePlan(plan, product, std::nullopt);
  for (const check::StepVerdict& step : verdict.steps) EXPECT_TRUE(step.valid()) << step.bodies.front();
  AssemblyPlan alone = plan;
  alone.steps[1].only().with.clear();
  const check::PlanVerdict refused = judgePlan(alone, product, std::nullopt);
  EXPECT_FALSE(refused.steps[1].valid()) << "the slot does not leave without the tongue";
}

TEST(MotionTrial, WhatAPersonWantsTogetherLeavesAsOne) {
  const AssembledProduct product = test::lockedDrawer();
  const ProductFits fits = test::fitsOf(product);
  MotionTrial trial(product, fits, 1, 0);
  test::QuietHost host;
  BodySet staying(4, false);
  staying[bodyNamed(product, "cabinet")] = true;
  const BodyGroup both{bodyNamed(product, "pin"), bodyNamed(product, "cap")};
  const AssemblyPlan plan = makeSequenceStrategyRegistry().find("greedy")->make()->plan(
      {product, staying, 1, trial, nullptr, {{both}, {}}}, host);
  ASSERT_EQ(plan.steps.size(), 2U);
  EXPECT_EQ(plan.steps[0].bodies(), (std::vector<BodyId>{"pin", "cap"}));
  EXPECT_EQ(plan.steps[1].only().body, "drawer");
  EXPECT_EQ(plan.steps[1].after, std::vector<std::size_t>{1});
}

}  // namespace
}  // namespace glissade
