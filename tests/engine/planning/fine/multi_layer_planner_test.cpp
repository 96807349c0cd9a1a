#include "engine/planning/fine/multi_layer_planner.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/engine/support/shape_game.h"
#include "tests/engine/support/test_host.h"

namespace glissade {
namespace {

const test::KnownGame& tight(const std::string& shape) {
  static std::map<std::string, test::KnownGame> games;
  return games.try_emplace(shape, "tight", shape).first->second;
}

std::unique_ptr<Planner> make(const Problem& problem, const std::string& strategy, std::uint64_t seed = 1) {
  return makePlannerRegistry().find(strategy)->make(problem, seed);
}

std::vector<std::string> placesOf(const CoarsePlan& plan) {
  std::vector<std::string> names;
  for (const TopologicalStep& step : plan.steps) names.push_back(step.placeName);
  return names;
}

class SolvesTight : public testing::TestWithParam<const char*> {};

TEST_P(SolvesTight, WithACertifiedPathAndFewRandomConfigurations) {
  const Problem& problem = tight(GetParam()).loaded.problem;
  for (const std::uint64_t seed : {1U, 2U}) {
    TestHost host(problem, 100000);
    const auto planner = make(problem, "gts", seed);
    ASSERT_TRUE(planner->solve(host)) << "seed " << seed;
    EXPECT_LE(planner->counts().randomConfigurations, 2000U) << "seed " << seed;
    const Path& path = *planner->path();
    EXPECT_EQ(path.points.front().q, problem.start);
    EXPECT_EQ(path.points.back().q, std::get<Pose>(problem.goal));
    const auto query = problem.world->makeQuery();
    EXPECT_EQ(certifyPath(*query, path.configurations(), host.values[ParameterId::RequiredClearance]).status,
              CertificateStatus::Certified);
    const CoarsePlanPtr plan = coarsePlanOf(*planner);
    ASSERT_NE(plan, nullptr);
    for (const TopologicalStep& step : plan->steps) {
      EXPECT_EQ(step.result, StepResult::Solved) << step.placeName;
      EXPECT_FALSE(step.why.empty());
      EXPECT_FALSE(step.planner.empty()) << step.placeName;
    }
    EXPECT_EQ(plan->coarseConfigurations + plan->fineConfigurations, planner->counts().randomConfigurations);
  }
}

TEST_P(SolvesTight, TheSameSeedGrowsTheSameRoadmapBitByBit) {
  const Problem& problem = tight(GetParam()).loaded.problem;
  TestHost firstHost(problem, 100000);
  const auto first = make(problem, "gts", 5);
  first->solve(firstHost);
  const auto second = make(problem, "gts", 5);
  TestHost secondHost(problem, 100000);
  do {
    secondHost.stepsLeft = 7;  // the result does not depend on interruptions
  } while (!second->solve(secondHost) && !second->failure());
  ASSERT_EQ(first->nodes().size(), second->nodes().size());
  for (std::size_t i = 0; i < first->nodes().size(); ++i) EXPECT_EQ(first->nodes()[i].q, second->nodes()[i].q);
  EXPECT_EQ(first->path()->configurations(), second->path()->configurations());
}

INSTANTIATE_TEST_SUITE_P(Objects, SolvesTight, testing::ValuesIn(test::shapes().begin(), test::shapes().end()),
                         [](const auto& parameter) { return parameter.param; });

TEST(MultiLayerPlanner, WithoutSemanticsTheStarIsLedToAHoleThatItDoesNotFit) {
  const Problem& problem = tight("star").loaded.problem;
  TestHost host(problem, 100000);
  ASSERT_TRUE(host.values.set(ParameterId::StepSamples, 3000));
  const auto planner = make(problem, "gt");
  EXPECT_FALSE(planner->solve(host));
  ASSERT_TRUE(planner->failure());
  EXPECT_EQ(planner->failure()->kind, ErrorKind::NoPath);
  EXPECT_FALSE(planner->failure()->advice.empty());
  EXPECT_EQ(planner->path(), nullptr);
  const CoarsePlanPtr plan = coarsePlanOf(*planner);
  ASSERT_EQ(placesOf(*plan).at(1), "P8");
  int failed = 0;
  for (const TopologicalStep& step : plan->steps) {
    if (step.result != StepResult::Failed) continue;
    ++failed;
    EXPECT_LE(step.randomConfigurations, 3000U + 2000U);  // limits of the local planner and of the milestone
  }
  EXPECT_EQ(failed, 1);
  EXPECT_FALSE(planner->solve(host)) << "no path can come after a failure";
}

class EditsWhileRunning : public testing::Test {
 protected:
  Problem problem = tight("circle").loaded.problem;
  TestHost host{problem, 100000};

  void advance(Planner& planner, std::uint64_t steps) {
    host.stepsLeft = steps;
    planner.solve(host);
  }
};

TEST_F(EditsWhileRunning, WithoutAWayTheSearchOfTheWholeWorkspaceHasARowOfItsOwn) {
  const auto planner = make(problem, "gts");
  advance(*planner, 5);
  SemanticEdits edits = *problem.scene.edits;
  for (PlaceEdit& edit : edits.places) edit.attributes["forbidden"] = true;
  host.edits = std::make_shared<const SemanticEdits>(edits);
  advance(*planner, 4);
  const CoarsePlanPtr plan = coarsePlanOf(*planner);
  EXPECT_TRUE(plan->nodes.empty());
  EXPECT_FALSE(plan->forbidden.empty());
  EXPECT_EQ(plan->basis.edits, host.edits);
  ASSERT_EQ(plan->steps.size(), 1U);
  const TopologicalStep& row = plan->steps.front();
  EXPECT_EQ(row.place, TopologicalStep::kWholeWorkspace);
  EXPECT_EQ(row.result, StepResult::Running);
  EXPECT_EQ(row.planner, "contact-birrt");
  EXPECT_FALSE(row.why.empty());
}

TEST_F(EditsWhileRunning, AForbiddenPlaceChangesTheCoarsePath) {
  const auto planner = make(problem, "gts");
  advance(*planner, 5);
  const CoarsePlanPtr before = coarsePlanOf(*planner);
  ASSERT_NE(before, nullptr);
  const std::string hole = placesOf(*before).at(1);
  SemanticEdits edits = *problem.scene.edits;
  for (PlaceEdit& edit : edits.places) {
    if (edit.name == hole) edit.attributes["forbidden"] = true;
  }
  host.edits = std::make_shared<const SemanticEdits>(edits);
  advance(*planner, 2);
  const CoarsePlanPtr after = coarsePlanOf(*planner);
  EXPECT_GT(after->attempt, before->attempt);
  ASSERT_EQ(placesOf(*after).size(), 5U);
  EXPECT_NE(placesOf(*after).at(1), hole);
  EXPECT_EQ(placesOf(*before).at(1), hole) << "what was published has changed";
  advance(*planner, 100000);
  ASSERT_NE(planner->path(), nullptr);
  EXPECT_NE(placesOf(*coarsePlanOf(*planner)).at(1), hole);
}

TEST_F(EditsWhileRunning, RulesThatNameAnAttributeThatWasRemovedEndTheRun) {
  SemanticEdits edits = *problem.scene.edits;
  AttributeDefinition danger;
  danger.name = "danger";
  danger.type = AttributeType::Number;
  danger.initial = 1.0;
  edits.definitions = {danger};
  problem.scene.edits = std::make_shared<const SemanticEdits>(edits);
  StrategyRules rules = presetRules("gts");
  rules.edge = "distance * place.danger";
  problem.scene.rules = std::make_shared<const StrategyRules>(rules);
  const auto planner = make(problem, "own");
  advance(*planner, 5);
  ASSERT_FALSE(planner->failure());
  edits.definitions.clear();
  host.edits = std::make_shared<const SemanticEdits>(edits);
  advance(*planner, 5);
  ASSERT_TRUE(planner->failure());
  EXPECT_NE(toString(planner->failure()->reason).find("place.danger"), std::string::npos);
}

TEST_F(EditsWhileRunning, AMilestoneOfThePersonIsPassedThrough) {
  const auto& map = problem.scene.knowledge->environment->map;
  const auto first = make(problem, "gts");
  advance(*first, 100000);
  ASSERT_NE(first->path(), nullptr);
  const TopologicalStep last = coarsePlanOf(*first)->steps.at(3);  // the step into P3
  const Border& border = map.borders[static_cast<std::size_t>(last.border)];
  SemanticEdits edits = *problem.scene.edits;
  Pose q = Pose::translation(border.centre + Vector3(0.0, 0.05, 0.1));
  q.orientation = fromRollPitchYaw(0.1, 0.2, 0.3);
  edits.milestones = {{map.grid.centre(border.cells.front()), q}};
  problem.scene.edits = std::make_shared<const SemanticEdits>(edits);
  const auto planner = make(problem, "gts");
  advance(*planner, 100000);
  ASSERT_NE(planner->path(), nullptr);
  const auto way = planner->path()->configurations();
  EXPECT_NE(std::find(way.begin(), way.end(), q), way.end());
}

}  // namespace
}  // namespace glissade
