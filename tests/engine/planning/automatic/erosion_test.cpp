#include <gtest/gtest.h>

#include "engine/planning/automatic/eroded_worlds.h"
#include "engine/planning/automatic/erodible_mesh.h"
#include "engine/planning/automatic/move_to_clearance.h"
#include "engine/planning/automatic/retraction.h"
#include "tests/engine/fits/ring.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

TEST(ErodibleMesh, ABoxShrinksAndGrowsByTheDepthOnEverySide) {
  const TriangleMesh box = makeBox({0.4, 0.6, 1.0});
  for (const double depth : {0.05, -0.05}) {
    const Box3 result = boundingBox(ErodibleMesh(box).eroded(depth));
    EXPECT_TRUE(result.sizes().isApprox(Vector3(0.4, 0.6, 1.0) - Vector3::Constant(2.0 * depth), 1e-9)) << depth;
  }
}

TEST(ErodibleMesh, AThinPlateKeepsAFifthOfItsThickness) {
  const Box3 result = boundingBox(ErodibleMesh(makeBox({1.0, 1.0, 0.02})).eroded(0.05));
  EXPECT_NEAR(result.sizes().z(), 0.2 * 0.02, 1e-9);
  EXPECT_NEAR(result.sizes().x(), 0.9, 1e-9);
}

TEST(ErodibleMesh, ASphereStaysInsideItself) {
  const TriangleMesh sphere = makeSphere(1.0);
  EXPECT_NEAR(radiusAboutOrigin(ErodibleMesh(sphere).eroded(0.1)), radiusAboutOrigin(sphere) - 0.1, 5e-3);
}

TEST(ErodedWorlds, BuildsEachDepthOnceAndLeavesTheObjectAlone) {
  const Problem problem = windowProblem();
  ErodedWorlds worlds(problem.world);
  EXPECT_EQ(worlds.at(0.0), problem.world);
  const CollisionWorldPtr smaller = worlds.at(0.05);
  EXPECT_EQ(worlds.at(0.05), smaller);
  worlds.keepOnly(0.05);
  EXPECT_EQ(worlds.at(0.05), smaller);
  const CollisionWorldPtr smallest = worlds.at(0.1);
  worlds.keepOnly(0.05);
  EXPECT_NE(worlds.at(0.1), smallest);
  EXPECT_EQ(&smaller->obstacles(), &problem.world->obstacles());  // not copied
  // At this configuration the object overlaps the wall by 0.04: only the smaller object is free.
  const Pose q = Pose::translation({-0.26, 1.0, 0.0});
  EXPECT_TRUE(problem.world->makeQuery()->collides(q));
  EXPECT_NEAR(smaller->makeQuery()->nearestObstacle(q).distance, 0.01, 1e-9);
}

TEST(Retraction, TakesACollidingConfigurationToTheSurface) {
  const Problem problem = windowProblem();
  ErodedWorlds worlds(problem.world);
  const auto smaller = worlds.at(0.05)->makeQuery();
  const auto query = problem.world->makeQuery();
  const auto q = retracted(*smaller, Pose::translation({-0.26, 1.0, 0.0}), 0.051, problem.world->objectRadius());
  ASSERT_TRUE(q);
  EXPECT_FALSE(query->collides(*q));
  EXPECT_LT(query->nearestObstacle(*q).distance, 0.02);
}

TEST(Retraction, EndsUpBetweenOppositeContactsWhereThereIsRoom) {
  const Problem problem = windowProblem();  // the window is 1 m wide, the cube 0.4 m
  const auto query = problem.world->makeQuery();
  const auto q = retracted(*query, Pose::translation({0.0, 0.29, 0.0}), 0.25, problem.world->objectRadius());
  ASSERT_TRUE(q);
  EXPECT_GE(query->nearestObstacle(*q).distance, 0.25);
}

TEST(Retraction, GivesUpInsideAnObstacle) {
  const Problem problem = windowProblem();
  const auto query = problem.world->makeQuery();
  EXPECT_FALSE(retracted(*query, Pose::translation({0.0, 1.5, 0.0}), 0.01, problem.world->objectRadius()));
}

/// The cube of `windowProblem()` on the floor of its window, or `overlap` deep in it.
Pose onTheFloor(double overlap) { return Pose::translation({0.0, 0.1, -0.3 - overlap}); }

TEST(Freeing, PartsThatTouchOrOverlapALittleComeClearByAboutThat) {
  const Problem problem = windowProblem();
  const auto query = problem.world->makeQuery();
  constexpr double kClearance = 2e-6;
  for (const double overlap : {-1e-6, 0.0, 1e-6, 1e-4, 1e-3}) {
    const Pose q = onTheFloor(overlap);
    ASSERT_FALSE(query->clearAbove(q, kClearance)) << overlap;
    const auto clear = moveToClearance(problem.world, q, kClearance);
    ASSERT_TRUE(clear) << overlap;
    EXPECT_TRUE(query->clearAbove(*clear, kClearance)) << overlap;
    EXPECT_LT((clear->position - q.position).norm(), 2.5 * (std::abs(overlap) + 1e-4)) << overlap;
    EXPECT_EQ(*moveToClearance(problem.world, q, kClearance), *clear) << "not the same again";
  }
}

TEST(Freeing, WhatIsClearStaysAndWhatIsDeepInsideIsGivenUpWithItsDepth) {
  const Problem problem = windowProblem();
  EXPECT_EQ(*moveToClearance(problem.world, problem.start, 1e-6), problem.start);
  const auto deep = moveToClearance(problem.world, onTheFloor(0.1), 1e-6);
  ASSERT_FALSE(deep);
  const std::string& reason = toString(deep.error().reason);
  const std::string before = "overlaps 'below' by ";
  ASSERT_NE(reason.find(before), std::string::npos) << reason;
  EXPECT_NEAR(std::stod(reason.substr(reason.find(before) + before.size())), 95.0, 5.1) << reason;  // mm
}

/// A shaft that is slightly thicker than its hole can only move out.
TEST(Freeing, AShaftSlidesOutOfItsHole) {
  RigidBody ring = boxBody("ring", {1.0, 1.0, 1.0}, Pose::identity());
  ring.mesh = std::make_shared<const TriangleMesh>(test::makeRing(0.1, 0.3, 0.2, 40));
  const auto shaft = std::make_shared<const TriangleMesh>(test::makeRing(0.0, 0.100001, 0.4, 40));
  const auto world = CollisionWorld::build({ring}, shaft);
  const auto out = moveToClearance(world, Pose::identity(), 1e-6);
  ASSERT_TRUE(out) << toString(out.error().reason);
  EXPECT_TRUE(world->makeQuery()->clearAbove(*out, 2e-6));
  EXPECT_GE(std::abs(out->position.z()), 0.3);
  EXPECT_LT(out->position.norm(), 0.4);
}

}  // namespace
}  // namespace glissade
