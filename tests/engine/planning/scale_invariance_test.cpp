// Scaling lengths by a power of two changes no digit. So every strategy must find the same path, scaled, for a scene in
// micrometres and in kilometres.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/planning/planner.h"
#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

Pose scaledPose(const Pose& pose, double factor) { return {factor * pose.position, pose.orientation}; }

MeshPtr scaledMesh(const TriangleMesh& mesh, double factor) {
  return std::make_shared<const TriangleMesh>(scaled(mesh, Vector3::Constant(factor)));
}

Problem scaledProblem(const Problem& problem, double factor) {
  std::vector<RigidBody> bodies = problem.world->obstacles();
  for (RigidBody& body : bodies) {
    body.mesh = scaledMesh(*body.mesh, factor);
    body.X_WB = scaledPose(body.X_WB, factor);
  }
  Problem result = problem;
  result.world = CollisionWorld::build(std::move(bodies), scaledMesh(problem.world->object(), factor));
  result.start = scaledPose(problem.start, factor);
  result.goal = scaledPose(std::get<Pose>(problem.goal), factor);
  result.bounds = Box3(factor * problem.bounds.min(), factor * problem.bounds.max());
  result.scene.environment.cellSize *= factor;
  return result;
}

std::vector<Pose> solutionOf(const std::string& planner, const Problem& problem) {
  TestHost host(problem, 20000);
  const auto made = makePlannerRegistry().find(planner)->make(problem, 3);
  return made->solve(host) ? made->path()->configurations() : std::vector<Pose>();
}

class ScaleInvariance : public testing::TestWithParam<std::string> {};

TEST_P(ScaleInvariance, TheSamePathIsFoundInMicrometresAndInKilometres) {
  const Problem problem = windowProblem();
  const std::vector<Pose> expected = solutionOf(GetParam(), problem);
  ASSERT_FALSE(expected.empty());
  for (const int exponent : {-20, -10, 10, 20}) {
    const double factor = std::ldexp(1.0, exponent);
    const std::vector<Pose> found = solutionOf(GetParam(), scaledProblem(problem, factor));
    ASSERT_EQ(found.size(), expected.size()) << "2^" << exponent;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i], scaledPose(expected[i], factor)) << "2^" << exponent << ", configuration " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Strategies, ScaleInvariance, testing::Values("birrt", "contact-birrt", "gt", "gts", "auto"));

}  // namespace
}  // namespace glissade
