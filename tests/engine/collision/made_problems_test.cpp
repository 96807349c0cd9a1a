// Checks that the project's own problems are valid.
#include <gtest/gtest.h>

#include <set>

#include "engine/collision/collision_query.h"
#include "engine/geometry/mesh_audit.h"
#include "samples/made-problems/made_problems.h"

namespace glissade {
namespace {

MeshPtr shared(const TriangleMesh& mesh) { return std::make_shared<const TriangleMesh>(mesh); }

TEST(MadeProblems, AreClosedSolidsThatBeginAndEndInTheOpen) {
  std::set<std::string> names;
  for (const made::MadeProblem& problem : made::madeProblems()) {
    EXPECT_TRUE(names.insert(problem.name).second) << problem.name;
    EXPECT_TRUE(audit(problem.object).closed()) << problem.name;
    EXPECT_TRUE(audit(problem.obstacles).closed()) << problem.name;
    EXPECT_GT(audit(problem.object).volume, 0.0) << problem.name;
    EXPECT_GT(audit(problem.obstacles).volume, 0.0) << problem.name;
    EXPECT_TRUE(problem.workspace.contains(problem.start.position)) << problem.name;
    EXPECT_TRUE(problem.workspace.contains(problem.goal.position)) << problem.name;
    RigidBody body;
    body.name = "obstacles";
    body.mesh = shared(problem.obstacles);
    const auto query = CollisionWorld::build({body}, shared(problem.object))->makeQuery();
    EXPECT_FALSE(query->collides(problem.start)) << problem.name;
    EXPECT_FALSE(query->collides(problem.goal)) << problem.name;
  }
}

TEST(MadeProblems, ComeFromTheirSeedsAlone) {
  EXPECT_EQ(made::spiralAmongBars(1).obstacles.vertices, made::spiralAmongBars(1).obstacles.vertices);
  EXPECT_NE(made::spiralAmongBars(1).obstacles.vertices, made::spiralAmongBars(2).obstacles.vertices);
}

}  // namespace
}  // namespace glissade
