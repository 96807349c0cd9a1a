#include "engine/planning/automatic/modelled_threads.h"

#include <gtest/gtest.h>

#include "engine/files/scenario_io.h"
#include "engine/geometry/primitives.h"
#include "engine/planning/automatic/member.h"
#include "engine/planning/path_certificate.h"
#include "samples/nut-and-bolt/shapes.h"
#include "tests/engine/support/directories.h"
#include "tests/engine/support/independent_check.h"
#include "tests/engine/support/test_host.h"

namespace glissade {
namespace {

/// A bolt at a random pose, and a nut on it or above it.
struct NutOnBolt {
  explicit NutOnBolt(const nut_and_bolt::Shape& shape = {}, bool on = true, bool goalOut = true) {
    bolt.id = "bolt";
    bolt.name = "bolt";
    bolt.mesh = std::make_shared<const TriangleMesh>(nut_and_bolt::bolt(shape));
    bolt.X_WB.position = {0.02, -0.01, 0.03};
    bolt.X_WB.orientation = Quaternion(Eigen::AngleAxisd(0.8, Vector3(1.0, 2.0, 0.5).normalized()));
    const Pose assembled = bolt.X_WB * Pose::translation({0.0, 0.0, std::abs(shape.pitch)});
    const Pose away = bolt.X_WB * Pose::translation({0.01, 0.02, 0.05});
    problem.world = CollisionWorld::build({bolt}, std::make_shared<const TriangleMesh>(nut_and_bolt::nut(shape)));
    problem.start = on ? assembled : away;
    problem.goal = goalOut ? Goal(GoalOut{}) : Goal(on ? away : assembled);
    problem.bounds = Box3(Vector3::Constant(-0.3), Vector3::Constant(0.3));
  }

  bool judgedValid(const Path& path) const {
    const ParameterValues parameters(problem.world->objectRadius());
    return IndependentCheck({bolt}, problem.world->object())
               .check(path.configurations(), demandsOf(path.points, parameters))
               .status == CertificateStatus::Certified;
  }

  RigidBody bolt;
  Problem problem;
};

bool hasScrewMotions(const Problem& problem) {
  const auto members = makeMembers(problem);
  return std::any_of(members.begin(), members.end(), [](const Member& m) { return m.name == "screw-motions"; });
}

TEST(ModelledThreads, AxisAndPitchAreFoundInTheMeshes) {
  for (const double hand : {1.0, -1.0}) {
    nut_and_bolt::Shape shape;
    shape.pitch *= hand;
    const NutOnBolt parts(shape);
    const auto threads = findModelledThreads(*parts.problem.world, parts.problem.start);
    ASSERT_FALSE(threads.empty());
    const Vector3 axis = parts.bolt.X_WB.orientation * Vector3::UnitZ();
    double bestAxis = 1.0;
    for (const ModelledThread& thread : threads) {
      EXPECT_NEAR(thread.screw.pitch, shape.pitch, 1e-3 * nut_and_bolt::kPitch);
      EXPECT_LT((parts.bolt.X_WB.position - thread.screw.point_W).cross(axis).norm(), 3e-5);
      bestAxis = std::min(bestAxis, thread.screw.axis_W.cross(axis).norm());
    }
    EXPECT_LT(bestAxis, 1e-4);
  }
}

/// The sample is the output of its program, and is solved as it is.
TEST(ModelledThreads, TheSampleIsWhatItsShapesAre) {
  const auto loaded = loadScenario(test::sourceDirectory() + "/samples/nut-and-bolt/scenario.json");
  ASSERT_TRUE(loaded.ok()) << toString(loaded.error());
  const auto isAlike = [](const TriangleMesh& a, const TriangleMesh& b) {
    const Box3 one = boundingBox(a);
    const Box3 other = boundingBox(b);
    return a.triangles.size() == b.triangles.size() && a.vertices.size() == b.vertices.size() &&
           one.min().isApprox(other.min(), 1e-6) && one.max().isApprox(other.max(), 1e-6);
  };
  EXPECT_TRUE(isAlike(*loaded->object.mesh, nut_and_bolt::nut()));
  EXPECT_TRUE(isAlike(*loaded->obstacles.front().mesh, nut_and_bolt::bolt()));
  EXPECT_TRUE(hasScrewMotions(loaded->problem));
}

/// Problems without threads have the same members as before.
TEST(ModelledThreads, AreNotFoundWhereThereAreNone) {
  EXPECT_TRUE(hasScrewMotions(NutOnBolt().problem));
  EXPECT_TRUE(hasScrewMotions(NutOnBolt({}, false, false).problem));
  EXPECT_FALSE(hasScrewMotions(NutOnBolt({}, false, true).problem));
  // A peg in its hole, and a box on a box.
  RigidBody block;
  block.id = "block";
  block.name = "block";
  block.mesh = std::make_shared<const TriangleMesh>(makeBox(Vector3(0.1, 0.1, 0.1)));
  Problem problem;
  problem.world = CollisionWorld::build({block}, std::make_shared<const TriangleMesh>(makeCylinder(0.02, 0.1)));
  problem.start = Pose::translation({0.0, 0.0, 0.1001});
  problem.goal = GoalOut{};
  problem.bounds = Box3(Vector3::Constant(-1.0), Vector3::Constant(1.0));
  EXPECT_FALSE(hasScrewMotions(problem));
}

TEST(ModelledThreads, ANutIsTurnedOffAndOn) {
  for (const auto& [on, goalOut] : {std::pair(true, true), {true, false}, {false, false}}) {
    const NutOnBolt parts({}, on, goalOut);
    auto planner = makePlannerRegistry().find("auto")->make(parts.problem, 1);
    TestHost host(parts.problem, 2000);
    ASSERT_TRUE(planner->solve(host)) << on << goalOut;
    if (on && goalOut) {
      EXPECT_TRUE(parts.judgedValid(*planner->path()));
    }
    double turns = 0.0;
    const auto poses = planner->path()->configurations();
    for (std::size_t i = 0; i + 1 < poses.size(); ++i)
      turns += angleBetween(poses[i].orientation, poses[i + 1].orientation);
    EXPECT_GT(turns, 6.0 * 2.0 * std::numbers::pi);  // several full turns
  }
}

TEST(ModelledThreads, ABoltIsTurnedOutOfANut) {
  const nut_and_bolt::Shape shape;
  RigidBody nut;
  nut.id = "nut";
  nut.name = "nut";
  nut.mesh = std::make_shared<const TriangleMesh>(nut_and_bolt::nut(shape));
  Problem problem;
  problem.world = CollisionWorld::build({nut}, std::make_shared<const TriangleMesh>(nut_and_bolt::bolt(shape)));
  problem.start = Pose::translation({0.0, 0.0, -2.0 * nut_and_bolt::kPitch});
  problem.goal = GoalOut{};
  problem.bounds = Box3(Vector3::Constant(-0.3), Vector3::Constant(0.3));
  auto planner = makePlannerRegistry().find("auto")->make(problem, 1);
  TestHost host(problem, 2000);
  ASSERT_TRUE(planner->solve(host));
  EXPECT_EQ(planner->path()->certificate.status, CertificateStatus::Certified);
}

}  // namespace
}  // namespace glissade
