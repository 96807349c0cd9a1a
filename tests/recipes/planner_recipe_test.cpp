// Carries out the recipe "Add a planner".
#include <gtest/gtest.h>

#include "engine/planning/direct_planner.h"
#include "engine/planning/path_certificate.h"
#include "engine/session/session_with_planners.h"
#include "tests/engine/planning/planner_conformance.h"
#include "tests/engine/support/independent_check.h"
#include "tests/engine/support/session_support.h"

namespace glissade {
namespace {

/// Goes straight to the goal, or by way of the middle of the workspace.
class MiddlePlanner final : public DirectPlanner {
 public:
  explicit MiddlePlanner(const Problem& problem) : DirectPlanner(problem) {}

 private:
  std::optional<Pose> next(const Pose& q, bool& done, PlannerHost& host) override {
    const auto isFree = [&](const Pose& to) {
      return freeFraction(query(), q, to, host.parameters()[ParameterId::GrowthStep], host.stopToken()) >= 1.0;
    };
    done = isFree(*goal());
    if (done) return goal();
    const Pose middle{problem().bounds.center(), q.orientation};
    if (q == middle || !isFree(middle)) return std::nullopt;
    return middle;
  }
};

PlannerEntry middlePlanner() {
  return {"middle",
          GLISSADE_TEXT("By way of the middle"),
          GLISSADE_TEXT("Straight, or by way of the middle of the workspace."),
          false,
          false,
          [](const Problem& problem, std::uint64_t) -> std::unique_ptr<Planner> {
            return std::make_unique<MiddlePlanner>(problem);
          }};
}

PlannerRegistry wholePlanners() {
  PlannerRegistry registry = makePlannerRegistry();
  registry.add(withScrewMotions(middlePlanner()));
  return registry;
}

PlannerRegistry localPlanners() {
  PlannerRegistry registry = makeLocalPlannerRegistry();
  registry.add(middlePlanner());
  return registry;
}

/// The start has a wall before it, so that the straight motion is blocked.
Problem besideTheWindow() {
  Problem problem = windowProblem();
  problem.start = Pose::translation({-1.5, 1.0, 0.0});
  return problem;
}

TEST(PlannerRecipe, ASessionRunsTheNewPlannerByItsIdAndTheJudgeAgreesWithItsPath) {
  const Problem problem = besideTheWindow();
  const auto run = [&](const char* planner) {
    SessionConfig config = sessionConfig(problem);
    config.plannerId = planner;
    const auto session = makeLockstepSession(std::move(config), wholePlanners());
    session->post(command::Start{});
    session->advance(10);
    return session->snapshot();
  };
  const SnapshotPtr snapshot = run("middle");
  ASSERT_EQ(snapshot->state, SessionState::Solved);
  EXPECT_EQ(snapshot->plannerId, "middle");
  ASSERT_EQ(snapshot->path->points.size(), 3U);
  EXPECT_EQ(snapshot->path->certificate.status, CertificateStatus::Certified);

  const IndependentCheck judge(problem.world->obstacles(), problem.world->object());
  const double required = snapshot->parameters[ParameterId::RequiredClearance];
  const MotionCertificate verdict =
      judge.check(snapshot->path->configurations(), {{required, false}, {required, false}});
  EXPECT_EQ(verdict.status, CertificateStatus::Certified);
  EXPECT_GE(verdict.provedClearance, required);
}

}  // namespace

std::vector<PlannerUnderTest> plannersUnderTest() {
  return {{wholePlanners, "recipe", "middle", 1, true}, {localPlanners, "local_recipe", "middle", 1, true}};
}

}  // namespace glissade
