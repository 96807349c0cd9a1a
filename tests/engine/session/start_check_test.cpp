#include "engine/session/start_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

ErrorKind kindOf(const Problem& problem) {
  const Outcome outcome = checkStart(problem, 1e-5);
  EXPECT_FALSE(outcome);
  return outcome ? ErrorKind::Internal : outcome.error().kind;
}

TEST(StartCheck, AcceptsASoundProblem) { EXPECT_TRUE(checkStart(windowProblem(), 1e-5)); }

TEST(StartCheck, RefusesWhatCannotBePlanned) {
  Problem problem = windowProblem();
  problem.goal = Pose::identity() * Pose::translation({0, 2, 0});
  EXPECT_EQ(kindOf(problem), ErrorKind::InCollision);

  problem = windowProblem();
  problem.start.position.x() = -100.0;
  EXPECT_EQ(kindOf(problem), ErrorKind::MalformedInput);

  problem = windowProblem();
  problem.start.position.x() = std::nan("");
  EXPECT_EQ(kindOf(problem), ErrorKind::MalformedInput);

  problem = windowProblem();
  problem.bounds = Box3();
  EXPECT_EQ(kindOf(problem), ErrorKind::MalformedInput);

  problem = windowProblem();
  problem.goal = GoalOut{};
  problem.start = Pose::translation({-0.41, 0.0, 0.0});
  problem.bounds = Box3(Vector3::Constant(-0.42), Vector3::Constant(0.42));
  EXPECT_EQ(kindOf(problem), ErrorKind::MalformedInput);  // no room within the bounds
}

TEST(StartCheck, RefusesMilestonesOutsideOfTheWorkspaceAndInCollision) {
  const auto refusalOf = [](const Pose& q) {
    Problem problem = windowProblem();
    auto edits = std::make_shared<SemanticEdits>();
    edits->milestones = {{Vector3::Zero(), problem.start}, {Vector3::Zero(), q}};
    problem.scene.edits = edits;
    const Outcome outcome = checkMilestones(problem);
    return outcome ? std::string() : toString(outcome.error().location) + ": " + toString(outcome.error().reason);
  };
  EXPECT_EQ(refusalOf(windowProblem().start), "");
  EXPECT_EQ(refusalOf(Pose::translation({1e3, 0, 0})), "/milestones/1: the milestone lies outside the workspace");
  EXPECT_NE(refusalOf(Pose::translation({0, 2, 0})).find("/milestones/1: the milestone is in collision"),
            std::string::npos);
}

TEST(StartCheck, NearerThanTheRequiredClearanceCountsAsCollision) {
  Problem problem = windowProblem();
  problem.start = Pose::translation({-0.35, 1.2, 0.0});  // 5 cm from the wall
  EXPECT_TRUE(checkStart(problem, 0.04));
  const Outcome outcome = checkStart(problem, 0.06);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::InCollision);
}

}  // namespace
}  // namespace glissade
