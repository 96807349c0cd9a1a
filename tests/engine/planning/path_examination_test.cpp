#include "engine/planning/path_examination.h"

#include <gtest/gtest.h>

#include "engine/planning/path_bounds.h"
#include "engine/planning/path_certificate.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

/// A path through the window, in steps of half a metre.
std::vector<PathPoint> throughTheWindow() {
  std::vector<PathPoint> points;
  for (int i = 0; i <= 6; ++i) points.push_back({Pose::translation({-1.5 + 0.5 * i, 0.0, 0.0}), Author::Computer});
  points.push_back({Pose::translation({1.5, 0.5, 0.5}), Author::Computer});
  return points;
}

TEST(PathExamination, APathThatHoldsHasItsWholeCertificate) {
  const Problem problem = windowProblem();
  const PathExamination examined = examinePath(throughTheWindow(), problem, TestHost(problem).values);
  EXPECT_TRUE(examined.holds());
  EXPECT_TRUE(examined.blocked.empty());
  EXPECT_EQ(examined.path.certificate.status, CertificateStatus::Certified);
  EXPECT_EQ(examined.path.certificate.edges.size() + 1, examined.path.points.size());
}

TEST(PathExamination, APathThatLeavesTheWorkspaceIsRefusedOnTheEdgeThatDoes) {
  const Problem problem = windowProblem();
  const ParameterValues values = TestHost(problem).values;
  const double beyond = problem.bounds.max().y() + 1e-3;
  for (const double far : {beyond, 1e6, 1e9}) {
    std::vector<PathPoint> points = throughTheWindow();
    points.insert(points.begin() + 3, {Pose::translation({-0.5, far, 0.0}), Author::Operator});
    EXPECT_EQ(firstOutside(points, problem), std::optional<std::size_t>(3));
    const PathExamination examined = examinePath(points, problem, values);
    EXPECT_FALSE(examined.holds());
    ASSERT_EQ(examined.blocked.size(), 1U);
    EXPECT_EQ(examined.blocked[0].edge, 2U);
  }
  EXPECT_EQ(firstOutside(throughTheWindow(), problem), std::nullopt);
}

TEST(PathExamination, EveryBlockedEdgeIsNamedWithWhatIsInTheWay) {
  Problem problem = windowProblem();
  std::vector<RigidBody> bodies = problem.world->obstacles();
  bodies.push_back(boxBody("crate", {0.2, 0.2, 0.2}, Pose::translation({-1.0, 0.3, 0.0})));
  bodies.push_back(boxBody("post", {0.1, 0.1, 2.0}, Pose::translation({1.5, 0.25, 0.5})));
  problem.world = CollisionWorld::build(bodies, std::make_shared<const TriangleMesh>(problem.world->object()));
  const PathExamination examined = examinePath(throughTheWindow(), problem, TestHost(problem).values);
  EXPECT_FALSE(examined.holds());
  EXPECT_TRUE(examined.ends.start && examined.ends.goal);
  std::vector<std::pair<std::size_t, std::string>> found;
  for (const BlockedEdge& edge : examined.blocked) {
    found.emplace_back(edge.edge, bodies[static_cast<std::size_t>(edge.nearest.body)].name);
  }
  const std::vector<std::pair<std::size_t, std::string>> expected{{0, "crate"}, {1, "crate"}, {5, "post"}, {6, "post"}};
  EXPECT_EQ(found, expected);
}

TEST(PathExamination, OfRandomPathsTheBlockedEdgesAreThoseThatAreRefusedOneByOne) {
  const Problem problem = windowProblem();
  const ParameterValues values = TestHost(problem).values;
  const auto query = problem.world->makeQuery();
  RandomStream stream(1, "paths");
  std::size_t blocked = 0;
  for (int i = 0; i < 100; ++i) {
    std::vector<PathPoint> points{{problem.start, Author::Computer}};
    for (int k = 0; k < 4; ++k) points.push_back({randomPose(stream, 1.5), Author::Computer});
    std::vector<std::size_t> expected;
    for (std::size_t edge = 0; edge + 1 < points.size(); ++edge) {
      if (firstRefusedEdge(*query, {points[edge], points[edge + 1]}, values)) expected.push_back(edge);
    }
    const PathExamination examined = examinePath(points, problem, values);
    ASSERT_EQ(examined.blocked.size(), expected.size()) << i;
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_EQ(examined.blocked[k].edge, expected[k]) << i;
    blocked += expected.size();
  }
  EXPECT_GT(blocked, 20U);
  EXPECT_LT(blocked, 380U);
}

TEST(PathExamination, APathOfAnotherProblemDoesNotHold) {
  Problem problem = windowProblem();
  problem.start.position.y() += 0.01;
  PathExamination examined = examinePath(throughTheWindow(), problem, TestHost(problem).values);
  EXPECT_FALSE(examined.ends.start);
  EXPECT_TRUE(examined.ends.goal);
  EXPECT_TRUE(examined.blocked.empty());
  EXPECT_FALSE(examined.holds());
  problem = windowProblem();
  problem.goal = GoalOut{};
  std::vector<PathPoint> points = throughTheWindow();
  EXPECT_TRUE(endsOf(points, problem).goal);
  points.resize(4);  // the path ends in the window
  EXPECT_FALSE(endsOf(points, problem).goal);
  EXPECT_TRUE(endsOf(points, problem).start);
}

TEST(PathExamination, OneConfigurationIsAPathToo) {
  Problem problem = windowProblem();
  problem.goal = problem.start;
  EXPECT_TRUE(examinePath({{problem.start, Author::Computer}}, problem, TestHost(problem).values).holds());
  const Pose inTheWall = Pose::translation({0.0, 1.5, 0.0});
  const PathExamination examined = examinePath({{inTheWall, Author::Computer}}, problem, TestHost(problem).values);
  ASSERT_EQ(examined.blocked.size(), 1U);
  EXPECT_EQ(examined.blocked.front().edge, 0U);
}

TEST(PathExamination, AStopLeavesItIncomplete) {
  const Problem problem = windowProblem();
  StopSource stop;
  stop.requestStop();
  const PathExamination examined =
      examinePath(throughTheWindow(), problem, TestHost(problem).values, WorkWatch(stop.token()));
  EXPECT_FALSE(examined.complete);
  EXPECT_FALSE(examined.holds());
}

}  // namespace
}  // namespace glissade
