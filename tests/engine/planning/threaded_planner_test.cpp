#include "engine/planning/threaded_planner.h"

#include <gtest/gtest.h>

#include "engine/collision/thread_rule.h"
#include "engine/geometry/primitives.h"
#include "engine/planning/path_certificate.h"
#include "engine/planning/screw_motion.h"
#include "engine/planning/smoothing/shortcuts.h"
#include "tests/engine/fits/screwed_parts.h"
#include "tests/engine/support/independent_check.h"
#include "tests/engine/support/test_host.h"

namespace glissade {
namespace {

constexpr double kNutAt = 0.0125;
/// Length of the nut's motion to the end of the bolt.
constexpr double kWayOff = 0.5 * test::kBoltLength - (kNutAt - 0.5 * test::kNutLength);

/// A bolt along z, a nut on it, and a plate below the nut with a hole for the bolt.
struct Bolted {
  explicit Bolted(bool nutMoves, const FitSettings& settings = test::markedThread(), bool goalOut = true) {
    const RigidBody nut = test::partAt("nut", test::hexNut(), Pose::translation({0.0, 0.0, kNutAt}));
    const RigidBody bolt = test::partAt("bolt", test::plainBolt(), Pose::identity());
    const RigidBody plate =
        test::partAt("plate", test::makeRing(0.006, 0.03, 0.006, 40), Pose::translation({0.0, 0.0, kNutAt - 0.007}));
    object = nutMoves ? nut : bolt;
    obstacles = {nutMoves ? bolt : nut, plate};
    Pose away = object.X_WB;
    away.position += Vector3(0.05, 0.02, 0.06);
    std::vector<Pose> ends{object.X_WB};
    if (!goalOut) ends = {away, object.X_WB};
    parts = *test::fitted(obstacles, object, ends, settings);
    problem.world = parts.world;
    problem.start = ends.front();
    problem.goal = goalOut ? Goal(GoalOut{}) : Goal(object.X_WB);
    problem.bounds = Box3(Vector3::Constant(-0.2), Vector3::Constant(0.2));
  }

  std::unique_ptr<Planner> plan(const std::string& id) const {
    auto planner = makePlannerRegistry().find(id)->make(problem, 1);
    TestHost host(problem, 400);
    planner->solve(host);
    return planner;
  }
  bool judgedValid(const Path& path) const {
    const IndependentCheck judge(parts.fits.allowed, parts.product, threadRulesOf(parts.fits.allowed));
    const ParameterValues parameters(problem.world->objectRadius());
    return judge.check(path.configurations(), demandsOf(path.points, parameters)).status ==
           CertificateStatus::Certified;
  }
  double turnsOf(const Path& path) const {
    return turnsWhileEngaged(problem.world->threads().front(), path.configurations());
  }

  RigidBody object;
  std::vector<RigidBody> obstacles;
  test::FittedParts parts;
  Problem problem;
};

TEST(ThreadedPlanner, TurnsANutOffItsBolt) {
  const Bolted bolted(true);
  for (const char* strategy : {"auto", "ompl-rrtconnect"}) {
    const auto planner = bolted.plan(strategy);
    ASSERT_NE(planner->path(), nullptr) << strategy << (planner->failure() ? toString(*planner->failure()) : "");
    EXPECT_EQ(planner->path()->certificate.status, CertificateStatus::Certified);
    EXPECT_TRUE(bolted.judgedValid(*planner->path())) << strategy;
    EXPECT_NEAR(bolted.turnsOf(*planner->path()), kWayOff / test::kCoarsePitch, 0.1);  // turns to the end of the bolt
    EXPECT_EQ(planner->nodes().size(), planner->counts().nodes);
  }
}

TEST(ThreadedPlanner, ScrewsANutOn) {
  const Bolted bolted(true, test::markedThread(), false);
  const auto planner = bolted.plan("auto");
  ASSERT_NE(planner->path(), nullptr);
  EXPECT_TRUE(bolted.judgedValid(*planner->path()));
  EXPECT_NEAR(bolted.turnsOf(*planner->path()), -kWayOff / test::kCoarsePitch, 0.1);
  EXPECT_EQ(planner->path()->points.back().q.position, bolted.object.X_WB.position);
}

TEST(ThreadedPlanner, AStopIsNoFailureAndTheNextTurnDelivers) {
  const Bolted bolted(true);
  const auto planner = makePlannerRegistry().find("auto")->make(bolted.problem, 1);
  TestHost stopped(bolted.problem, 400);
  StopSource source;
  stopped.stop = source.token();
  source.requestStop();
  EXPECT_FALSE(planner->solve(stopped));
  EXPECT_FALSE(planner->failure()) << toString(*planner->failure());
  TestHost host(bolted.problem, 400);
  EXPECT_TRUE(planner->solve(host));
  EXPECT_NE(planner->path(), nullptr);
}

TEST(ThreadedPlanner, ShortcutsKeepTheThread) {
  const Bolted bolted(true);
  const auto planner = bolted.plan("auto");
  ASSERT_NE(planner->path(), nullptr);
  const ParameterValues parameters(bolted.problem.world->objectRadius());
  const Path shorter = withShortcuts(*planner->path(), bolted.problem, parameters, 1, 300, {});
  EXPECT_LT(shorter.points.size(), planner->path()->points.size());
  EXPECT_TRUE(bolted.judgedValid(shorter));
  EXPECT_NEAR(bolted.turnsOf(shorter), bolted.turnsOf(*planner->path()), 0.1);
}

TEST(ThreadedPlanner, ALooseNutHoldsItsBolt) {
  const Bolted bolted(false);
  ASSERT_TRUE(bolted.parts.fits.allowed.front().thread);
  EXPECT_FALSE(bolted.parts.fits.allowed.front().thread->rule.mayTurn);
  const auto planner = bolted.plan("auto");
  EXPECT_EQ(planner->path(), nullptr);
  ASSERT_TRUE(planner->failure());
  EXPECT_EQ(planner->failure()->kind, ErrorKind::NoPath);
  EXPECT_NE(toString(planner->failure()->reason).find("'nut'"), std::string::npos)
      << toString(planner->failure()->reason);
  const auto query = bolted.problem.world->makeQuery();
  EXPECT_EQ(findScrewWays(*bolted.problem.world, *query, bolted.problem.start, 1e-7, {}).blockedBy,
            std::vector<int>{0});
}

TEST(ThreadedPlanner, ABoltIsTurnedOutOfANutThatIsHeld) {
  FitSettings settings = test::markedThread();
  settings.pairs.front().turned = "bolt";
  const Bolted bolted(false, settings);
  const auto planner = bolted.plan("auto");
  ASSERT_NE(planner->path(), nullptr);
  EXPECT_TRUE(bolted.judgedValid(*planner->path()));
}

/// Two walls beside the nut prevent it from turning.
TEST(ThreadedPlanner, ANutInASlotIsHeld) {
  const RigidBody nut = test::partAt("nut", test::hexNut(), Pose::identity());
  const RigidBody bolt = test::partAt("bolt", test::plainBolt(), Pose::identity());
  std::vector<RigidBody> obstacles{nut};
  for (const double side : {-1.0, 1.0}) {
    obstacles.push_back(
        test::partAt("wall", makeBox({0.03, 0.004, 0.01}), Pose::translation({0.0, side * 0.0101, 0.0})));
  }
  const auto parts = test::fitted(obstacles, bolt, {bolt.X_WB}, test::markedThread());
  ASSERT_TRUE(parts);
  EXPECT_TRUE(parts->fits.allowed.front().thread->rule.mayTurn);
}

TEST(ThreadedPlanner, WhatBlocksBothWaysIsNamed) {
  const RigidBody nut = test::partAt("nut", test::hexNut(), Pose::identity());
  const std::vector<RigidBody> obstacles{
      test::partAt("bolt", test::plainBolt(), Pose::identity()),
      test::partAt("lid", makeBox({0.02, 0.02, 0.002}), Pose::translation({0.0, 0.0, 0.0165})),
      test::partAt("floor", makeBox({0.02, 0.02, 0.002}), Pose::translation({0.0, 0.0, -0.0165}))};
  const auto parts = test::fitted(obstacles, nut, {nut.X_WB}, test::markedThread());
  ASSERT_TRUE(parts);
  const auto query = parts->world->makeQuery();
  const ScrewSearch search = findScrewWays(*parts->world, *query, nut.X_WB, 1e-7, {});
  EXPECT_TRUE(search.engaged);
  EXPECT_TRUE(search.ways.empty());
  EXPECT_EQ(search.blockedBy, (std::vector<int>{1, 2}));
}

TEST(ThreadedPlanner, AThreadNeedsACommonAxis) {
  const RigidBody nut = test::partAt("nut", test::hexNut(), Pose::identity());
  const RigidBody block = test::partAt("bolt", makeBox({0.004, 0.004, 0.03}), Pose::identity());
  const auto parts = test::fitted({block}, nut, {nut.X_WB}, test::markedThread());
  ASSERT_FALSE(parts);
  EXPECT_EQ(parts.error().kind, ErrorKind::MalformedInput);
  EXPECT_EQ(toString(parts.error().location), "/fits/pairs/0");
}

/// A thread that is modelled with clearance does not touch, but is still a thread.
TEST(ThreadedPlanner, AThreadMayBeDrawnWithClearance) {
  const RigidBody nut = test::partAt("nut", test::hexNut(0.00525), Pose::identity());
  const RigidBody bolt = test::partAt("bolt", test::plainBolt(), Pose::identity());
  const auto parts = test::fitted({bolt}, nut, {nut.X_WB}, test::markedThread());
  ASSERT_TRUE(parts);
  ASSERT_EQ(parts->fits.allowed.size(), 1U);
  EXPECT_EQ(parts->fits.allowed.front().allowance, 0.0);
  const auto query = parts->world->makeQuery();
  Pose pulled = nut.X_WB;
  pulled.position.z() += 0.1;
  EXPECT_EQ(query->checkMotion(nut.X_WB, pulled, 1e-7, SeekViolation::Any, {}).status, CertificateStatus::Violated);
  EXPECT_EQ(findScrewWays(*parts->world, *query, nut.X_WB, 1e-7, {}).ways.size(), 2U);
}

}  // namespace
}  // namespace glissade
