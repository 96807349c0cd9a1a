#include "engine/planning/automatic/straight_end.h"

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "engine/planning/path_certificate.h"
#include "tests/engine/support/independent_check.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

/// A cube of 0.1 m in a tube that is open at +x, 0.02 m wider than the cube.
Problem tube() {
  std::vector<RigidBody> walls{boxBody("end", {0.1, 0.4, 0.4}, Pose::translation({-0.2, 0.0, 0.0}))};
  for (const double side : {-1.0, 1.0}) {
    walls.push_back(boxBody("wall", {0.6, 0.1, 0.4}, Pose::translation({0.15, 0.11 * side, 0.0})));
    walls.push_back(boxBody("lid", {0.6, 0.12, 0.1}, Pose::translation({0.15, 0.0, 0.11 * side})));
  }
  Problem problem;
  problem.world = CollisionWorld::build(walls, std::make_shared<const TriangleMesh>(makeBox({0.1, 0.1, 0.1})));
  problem.goal = GoalOut{};
  problem.bounds = {Vector3::Constant(-2.0), Vector3::Constant(2.0)};
  return problem;
}

Path certified(const std::vector<Vector3>& way, const Problem& problem, const ParameterValues& parameters) {
  Path path;
  for (const Vector3& position : way) path.points.push_back({Pose::translation(position), Author::Computer});
  path.certificate = certifyPath(*problem.world->makeQuery(), path.points, parameters);
  return path;
}

/// A path out of the tube with random deviations, and by a detour to the other side of it.
std::vector<Vector3> detour(std::uint64_t seed) {
  RandomStream stream(seed, "detour");
  const auto tremor = [&stream](double size) {
    return size * Vector3(stream.uniform() - 0.5, stream.uniform() - 0.5, stream.uniform() - 0.5);
  };
  std::vector<Vector3> way{Vector3::Zero()};
  for (double x = 0.05; x < 0.7; x += 0.05) way.push_back(Vector3(x, 0.0, 0.0) + tremor(0.01));
  for (const Vector3& corner : {Vector3(0.8, 0.6, 0.0), Vector3(0.0, 0.8, 0.0), Vector3(-0.8, 0.6, 0.0)}) {
    way.push_back(corner + tremor(0.2));
  }
  way.push_back({-0.8, 0.0, 0.0});
  return way;
}

TEST(StraightEnd, LeavesByTheShortWayAndIsProvedByAnother) {
  const Problem problem = tube();
  const ParameterValues parameters(problem.world->objectRadius());
  const IndependentCheck judge(problem.world->obstacles(), problem.world->object());
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Path path = certified(detour(seed), problem, parameters);
    ASSERT_EQ(path.certificate.status, CertificateStatus::Certified);
    const Path straight = withStraightEnd(path, problem, parameters);
    EXPECT_LT(straight.length(), 1.0) << "the detour has more than 3 m";
    EXPECT_EQ(straight.points.front().q, path.points.front().q);
    EXPECT_EQ(straight.certificate.status, CertificateStatus::Certified);
    EXPECT_EQ(straight.certificate.edges.size() + 1, straight.points.size());
    EXPECT_EQ(judge.check(straight.configurations(), demandsOf(straight.points, parameters)).status,
              CertificateStatus::Certified);
    const Box3& box = problem.world->obstaclesBox();
    EXPECT_GE(box.exteriorDistance(straight.points.back().q.position), problem.world->objectRadius());
    EXPECT_TRUE(problem.bounds.contains(straight.points.back().q.position));
  }
}

TEST(StraightEnd, APathThatLeavesStraightAndOneToAPlaceStayAsTheyAre) {
  Problem problem = tube();
  const ParameterValues parameters(problem.world->objectRadius());
  const Path straight = certified({{0.0, 0.0, 0.0}, {0.3, 0.0, 0.0}, {0.5366, 0.0, 0.0}}, problem, parameters);
  EXPECT_EQ(withStraightEnd(straight, problem, parameters).configurations(), straight.configurations());
  const Path path = certified(detour(1), problem, parameters);
  problem.goal = path.points.back().q;
  EXPECT_EQ(withStraightEnd(path, problem, parameters).configurations(), path.configurations());
}

TEST(StraightEnd, StaysWithinTheBounds) {
  Problem problem = tube();
  problem.bounds = {Vector3(-2.0, -2.0, -2.0), Vector3(0.52, 2.0, 2.0)};
  const ParameterValues parameters(problem.world->objectRadius());
  const Path path = certified({{0.0, 0.0, 0.0}, {0.51, 0.0, 0.0}, {0.51, 0.6, 0.0}, {-0.8, 0.6, 0.0}, {-0.8, 0.0, 0.0}},
                              problem, parameters);
  const Path straight = withStraightEnd(path, problem, parameters);
  EXPECT_LT(straight.length(), path.length());
  for (const PathPoint& point : straight.points) EXPECT_TRUE(problem.bounds.contains(point.q.position));
}

TEST(StraightEnd, StoppedItLeavesThePathAsItWas) {
  const Problem problem = tube();
  const ParameterValues parameters(problem.world->objectRadius());
  const Path path = certified(detour(2), problem, parameters);
  StopSource stop;
  stop.requestStop();
  EXPECT_EQ(withStraightEnd(path, problem, parameters, stop.token()).configurations(), path.configurations());
}

}  // namespace
}  // namespace glissade
