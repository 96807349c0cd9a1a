#include <gtest/gtest.h>

#include <set>

#include "engine/planning/automatic/contact_faces.h"
#include "engine/planning/automatic/direct_motions.h"
#include "engine/planning/automatic/shrink_repair.h"
#include "tests/engine/planning/automatic/member_conformance.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

TEST(Members, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  const auto members = makeMembers(windowProblem());
  for (const Member& member : members) names.insert(member.name);
  EXPECT_EQ(names.size(), members.size());
}

TEST(Members, TwoTreesHaveAHeadStartAmongDetailedParts) {
  const auto first = [](const Problem& problem) {
    std::set<std::string> names;
    for (const Member& member : makeMembers(problem)) {
      if (member.contender.entry == 0) names.insert(member.name);
    }
    return names;
  };
  Problem problem = windowProblem();
  EXPECT_EQ(first(problem), (std::set<std::string>{"direct-motions", "dynamic-domain", "turning-rrt", "ompl-bkpiece"}));
  std::vector<RigidBody> detailed = problem.world->obstacles();
  detailed.push_back(boxBody("part", {0.1, 0.1, 0.1}, Pose::translation({1.9, 1.9, 1.9})));
  detailed.back().mesh = std::make_shared<const TriangleMesh>(makeSphere(0.05, 5));
  problem.world = CollisionWorld::build(detailed, std::make_shared<const TriangleMesh>(problem.world->object()));
  EXPECT_EQ(first(problem), (std::set<std::string>{"direct-motions", "dynamic-domain"}));
}

TEST(Members, DeliverCertifiedPathsOrSayWhyNot) {
  const Problem problem = windowProblem();
  int solved = 0;
  for (const Member& member : makeMembers(problem)) solved += deliversOrSaysWhyNot(member, problem) ? 1 : 0;
  EXPECT_GE(solved, 5);
}

TEST(ContactFaces, ABoxHasSixTheLargestFirst) {
  const auto normals = largestFaceNormals(makeBox({1.0, 2.0, 3.0}), 12);
  ASSERT_EQ(normals.size(), 6U);
  EXPECT_NEAR(std::abs(normals[0].x()), 1.0, 1e-12);
  EXPECT_NEAR(std::abs(normals[5].z()), 1.0, 1e-12);
}

TEST(DirectMotions, LeavesStraightWhereTheWayOutIsFree) {
  Problem problem = windowProblem();
  problem.goal = GoalOut{};
  problem.bounds = Box3(Vector3::Constant(-5.0), Vector3::Constant(5.0));
  TestHost host(problem);
  DirectMotions planner(problem);
  ASSERT_TRUE(planner.solve(host));
  EXPECT_EQ(planner.path()->certificate.status, CertificateStatus::Certified);
  EXPECT_GE(problem.world->obstaclesBox().exteriorDistance(planner.path()->points.back().q.position),
            problem.world->objectRadius() - 1e-9);
}

TEST(DirectMotions, GivesUpInFrontOfAWallWithoutAWindow) {
  const Problem problem = closedProblem();
  TestHost host(problem);
  DirectMotions planner(problem);
  EXPECT_FALSE(planner.solve(host));
  EXPECT_TRUE(planner.failure());
}

TEST(ShrinkRepair, GrowsBackThroughAWindowThatJustFits) {
  Problem problem = windowProblem();
  // The cube of 0.96 m in the window of 1 m.
  problem.world = CollisionWorld::build(problem.world->obstacles(),
                                        std::make_shared<const TriangleMesh>(makeBox({0.96, 0.96, 0.96})));
  problem.goal = Pose::translation({1.5, 0.0, 0.0});
  const double r = problem.world->objectRadius();
  ShrinkRepair::Options options;
  options.erosion = 0.1 * r;
  options.growth = 1e-3 * r;
  options.search.range = 0.2;
  options.repairWork = 30'000;  // sometimes too few, so that the growth is halved
  const auto worlds = std::make_shared<ErodedWorlds>(problem.world);
  int solved = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    TestHost host(problem);
    ShrinkRepair planner(problem, seed, options, worlds);
    if (!planner.solve(host)) {
      EXPECT_TRUE(planner.failure());
      continue;
    }
    ++solved;
    EXPECT_GE(planner.stagesDone(), 6U);  // levels before the last
    EXPECT_EQ(planner.path()->points.front().q, problem.start);
    const auto query = problem.world->makeQuery();
    EXPECT_EQ(certifyPath(*query, planner.path()->configurations(), host.values[ParameterId::RequiredClearance]).status,
              CertificateStatus::Certified);
  }
  EXPECT_GE(solved, 2);
}

/// The smaller object of the first level is out of a tube sooner than the whole one.
TEST(ShrinkRepair, GoesOutAsFarAsTheWholeObjectHasTo) {
  Problem problem = windowProblem();
  problem.bounds = Box3(Vector3::Constant(-3.0), Vector3::Constant(3.0));
  problem.world = CollisionWorld::build({boxBody("left", {2.0, 0.2, 1.4}, Pose::translation({0.0, -0.6, 0.0})),
                                         boxBody("right", {2.0, 0.2, 1.4}, Pose::translation({0.0, 0.6, 0.0})),
                                         boxBody("below", {2.0, 1.0, 0.2}, Pose::translation({0.0, 0.0, -0.6})),
                                         boxBody("above", {2.0, 1.0, 0.2}, Pose::translation({0.0, 0.0, 0.6}))},
                                        std::make_shared<const TriangleMesh>(makeBox({0.9, 0.9, 0.9})));
  problem.start = Pose::identity();
  problem.goal = GoalOut{};
  const double r = problem.world->objectRadius();
  ShrinkRepair::Options options;
  options.erosion = 0.1 * r;
  options.growth = 1e-3 * r;
  options.search.range = 0.2;
  ShrinkRepair planner(problem, 1, options, std::make_shared<ErodedWorlds>(problem.world));
  TestHost host(problem);
  ASSERT_TRUE(planner.solve(host));
  EXPECT_NEAR(std::abs(planner.path()->points.back().q.position.x()), 1.0 + r, 1e-9);
}

}  // namespace
}  // namespace glissade
