#include "engine/planning/interactive/shown_configuration.h"

#include <gtest/gtest.h>

#include "engine/geometry/screw_axis.h"
#include "engine/planning/interactive/hand_account.h"
#include "engine/planning/interactive/way_sampler.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

/// The oracle shares no code with the kernel that freed the configurations.
TEST(ShownConfiguration, WhatIsFreedDoesNotPenetrateAndIsNear) {
  Problem problem = windowProblem();
  problem.world = problem.world->withObject(makeL());
  const auto oracle = problem.world->withBackend(CollisionBackend::Fcl)->makeQuery();
  ShownConfiguration configuration(problem, std::make_shared<ErodedWorlds>(problem.world), 1, 4);
  RandomStream stream(1, "shown");
  const double radius = problem.world->objectRadius();
  int collided = 0;
  int freed = 0;
  for (int i = 0; i < 400; ++i) {
    Pose q = randomPose(stream, 1.0);
    q.position.x() = stream.uniform(-0.5, 0.5);
    const bool collides = oracle->collides(q);
    const auto found = configuration.clearConfiguration(q, 1e-3 * radius);
    collided += collides ? 1 : 0;
    if (!found) {
      EXPECT_TRUE(collides);
      continue;
    }
    freed += collides ? 1 : 0;
    EXPECT_FALSE(oracle->collides(found->q));
    EXPECT_GT(oracle->nearestObstacle(found->q).distance, 0.0);
    EXPECT_LE(found->moved, ShownConfiguration::kMostMoved * radius);
    EXPECT_EQ(found->moved > 0.0, collides);
    EXPECT_NEAR(found->nearest.distance, oracle->nearestObstacle(found->q).distance, 1e-6);
  }
  EXPECT_GT(collided, 100);
  EXPECT_GT(freed, collided / 4);
}

TEST(WaySampler, DrawsTheHandsShareFromTheTube) {
  const Problem problem = windowProblem();
  const auto board = std::make_shared<WayBoard>();
  const auto sampler = [&](bool slides) {
    return WaySampler(problem, std::make_unique<UniformSampler>(problem, 1), 1, board, slides);
  };
  UniformSampler own(problem, 1);
  WaySampler nothingShown = sampler(true);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(nothingShown.draw(problem.bounds), own.draw(problem.bounds));
  auto way = std::make_shared<ShownWay>();
  way->points.push_back({Pose::translation({-1.2, 0.3, 0.2}),
                         problem.world->makeQuery()->nearestObstacle(Pose::translation({-1.2, 0.3, 0.2})), false});
  way->spread = 0.01;
  way->share = 0.25;
  way->slidersShare = 0.75;
  board->publish(way);
  const auto drawnNear = [&](bool slides) {
    WaySampler shown = sampler(slides);
    int near = 0;
    for (int i = 0; i < 400; ++i)
      near += (shown.draw(problem.bounds).position - way->points[0].q.position).norm() < 0.1 ? 1 : 0;
    return near;
  };
  EXPECT_NEAR(drawnNear(false), 100, 40);
  EXPECT_NEAR(drawnNear(true), 300, 40);
}

/// The hand turns a screw: in a tenth of its draws the object is on the screw motion ahead of it.
TEST(WaySampler, DrawsAheadOfAHandThatPushes) {
  const Problem problem = windowProblem();
  const ScrewAxis screw{{-1.2, 0.0, 0.0}, Vector3::UnitX(), 0.5};
  const Pose start = Pose::translation({-1.2, 0.3, 0.0});
  WayRecorder recorder(problem.metric());
  NearestObstacle far;
  far.distance = 1.0;
  for (int i = 0; i < 6; ++i) recorder.add(screwed(screw, start, 0.005 * i), far, 0.0);
  const Pose hand = screwed(screw, start, 0.03);  // obstacles hold the object at 0.025
  const auto board = std::make_shared<WayBoard>();
  auto way = std::make_shared<ShownWay>();
  way->points = recorder.points();
  way->push = recorder.push(hand);
  way->spread = recorder.spread();
  way->share = 1.0;
  board->publish(way);
  WaySampler sampler(problem, std::make_unique<UniformSampler>(problem, 1), 1, board, false);
  const auto onTheScrewAhead = [&](const Pose& q) {
    const double advance = q.position.x() - start.position.x();
    if (advance < 0.032) return false;
    return problem.metric().distance(q, screwed(screw, start, advance)) < 0.2 * problem.world->objectRadius();
  };
  int ahead = 0;
  for (int i = 0; i < 1000; ++i) ahead += onTheScrewAhead(sampler.draw(problem.bounds)) ? 1 : 0;
  EXPECT_GT(ahead, 50);
  EXPECT_LT(ahead, 150);
}

/// N and d also apply to the nodes of a member, while a hand has a share in its draws.
TEST(WaySampler, DrawsContactSamplesAtNodesOfTheMember) {
  const Problem problem = windowProblem();
  const auto query = problem.world->makeQuery();
  const Pose node = Pose::translation({-0.31, 1.5, 0.0});  // 10 mm before the wall, far from the hand
  NearestObstacle far;
  far.distance = 1.0;
  const auto drawnThere = [&](double share) {
    auto way = std::make_shared<ShownWay>();
    way->points.push_back({problem.start, far, false});
    way->contact = {10, 0.05, 0.001};
    way->spread = 0.05;
    way->share = share;
    const auto board = std::make_shared<WayBoard>();
    board->publish(way);
    WaySampler sampler(problem, std::make_unique<UniformSampler>(problem, 1), 1, board, false);
    int there = 0;
    for (int i = 0; i < 2000; ++i) {
      sampler.grew(node, *query);
      there += std::abs(sampler.draw(problem.bounds).position.x() - -0.301) < 1e-6 ? 1 : 0;
    }
    return there;
  };
  EXPECT_GT(drawnThere(0.8), 100);
  EXPECT_EQ(drawnThere(0.0), 0);
}

TEST(WayRecorder, SaysHowOftenTheHandIsInContact) {
  const Problem problem = windowProblem();
  const double radius = problem.world->objectRadius();
  WayRecorder way(problem.metric());
  NearestObstacle far;
  far.distance = radius;
  NearestObstacle touching;
  touching.distance = 0.01 * radius;
  way.add(problem.start, far, 0.0);
  EXPECT_EQ(way.inContact(), 0.0);
  way.add(problem.start, touching, 0.0);
  way.add(problem.start, far, 0.1 * radius);  // q was retracted
  way.add(problem.start, far, 0.0);
  EXPECT_NEAR(way.inContact(), 0.5, 1e-12);
  NearestObstacle deep;
  deep.distance = 0.0;
  way.add(problem.start, deep, 0.5 * radius);  // q could not be made free
  EXPECT_NEAR(way.inContact(), 0.4, 1e-12);
  for (int i = 0; i < 500; ++i) way.add(problem.start, far, 0.0);
  EXPECT_LT(way.inContact(), 0.01);
}

TEST(HandAccount, LimitsTheHandByWorkUnlessStepsAreScarce) {
  HandAccount account;
  EXPECT_TRUE(account.covers());
  account.charge(100'000, {1'000'000, 0});
  account.charge(1, {50'000, 50'000});
  EXPECT_FALSE(account.covers());
  account.noteShown(20);  // each gives a credit
  EXPECT_TRUE(account.covers());
  account.charge(1, {2'000'000, 2'000'000});
  EXPECT_FALSE(account.covers());
  for (std::uint64_t shown = 21; shown < 80; ++shown) {  // a dozen steps for each, as in lockstep
    account.charge(12, {60'000, 60'000});
    account.noteShown(shown);
  }
  EXPECT_TRUE(account.stepsAreScarce());
  EXPECT_TRUE(account.covers());
}

}  // namespace
}  // namespace glissade
