#include "engine/planning/contact/interaction_tuner.h"

#include <gtest/gtest.h>

#include "engine/planning/contact/interactive_contact_birrt.h"
#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

constexpr double kRadius = 1.536;
constexpr double kNewGround = InteractionTuner::kNewGround * kRadius;

void observe(InteractionTuner& tuner, const StepOutcome& outcome, int times) {
  for (int i = 0; i < times; ++i) tuner.observe(outcome);
}

TEST(StepMedian, IsTheMedianOfWhatWasAdded) {
  StepMedian median(10);
  EXPECT_EQ(median.value(), 0U);
  for (const std::size_t value : {9U, 2U, 10U, 7U, 2U}) median.add(value);
  EXPECT_EQ(median.value(), 7U);
  median.add(0);
  EXPECT_EQ(median.value(), 2U);  // the lower one of 2 and 7
}

/// The tuned alpha where each author breaks new ground once in a number of configurations; the draws are even.
double tunedAlpha(int computerOnceIn, int operatorOnceIn) {
  InteractionTuner tuner(kRadius);
  for (int i = 0; i < 4000; ++i) {
    tuner.observe({Author::Computer, i % computerOnceIn == 0 ? kNewGround : 0.0, 0.0});
    tuner.observe({Author::Operator, i % operatorOnceIn == 0 ? kNewGround : 0.0, 0.0});
  }
  return tuner.settings().alpha;
}

TEST(InteractionTuner, DrawsAreSharedInProportionToTheNewGround) {
  EXPECT_NEAR(tunedAlpha(1, 1), 1.0 / (1.0 + 1.0 + InteractionTuner::kTrust), 0.01);
  EXPECT_NEAR(tunedAlpha(1, 4), 1.0 / (1.0 + 0.25 + InteractionTuner::kTrust), 0.01);
  EXPECT_NEAR(tunedAlpha(4, 1), 0.25 / (0.25 + 1.0 + InteractionTuner::kTrust), 0.01);
}

TEST(InteractionTuner, TheComputerLeadsWhereTheHandWaitsAndAPersonWhereTheComputerIsStuck) {
  InteractionTuner handWaits(kRadius);
  InteractionTuner computerIsStuck(kRadius);
  for (int i = 0; i < 4000; ++i) {
    handWaits.observe({Author::Computer, i % 2 == 0 ? kNewGround : 0.0, 0.0});
    handWaits.observe({Author::Operator, 0.0, 0.0});
    computerIsStuck.observe({Author::Computer, 0.0, 0.0});
    computerIsStuck.observe({Author::Operator, i % 2 == 0 ? kNewGround : 0.0, 0.0});
  }
  EXPECT_NEAR(handWaits.settings().alpha, 0.5 / (0.5 + InteractionTuner::kTrust), 0.01);
  EXPECT_DOUBLE_EQ(computerIsStuck.settings().alpha, InteractionTuner::kLeastAlpha);
}

TEST(InteractionTuner, GrowthThatBreaksNoNewGroundEarnsNoDraws) {
  InteractionTuner creeps(kRadius);
  InteractionTuner rests(kRadius);
  for (int i = 0; i < 2000; ++i) {
    creeps.observe({Author::Operator, 0.99 * kNewGround, 0.0});
    rests.observe({Author::Operator, 0.0, 0.0});
  }
  EXPECT_DOUBLE_EQ(creeps.settings().alpha, rests.settings().alpha);
}

TEST(InteractionTuner, ContactModeIsToBringAsManyNodesWhereverSamplesFail) {
  for (const int onceIn : {1, 2, 4}) {
    InteractionTuner tuner(kRadius);
    for (int i = 0; i < 4000; ++i) tuner.observe({Author::Contact, i % onceIn == 0 ? 0.01 : 0.0, 0.05});
    const double nodes = static_cast<double>(tuner.settings().contactSamples) / onceIn;
    EXPECT_NEAR(nodes, InteractionTuner::kNodesPerContact, 1.0) << onceIn;
  }
  InteractionTuner tuner(kRadius);
  observe(tuner, {Author::Contact, 0.0, 0.05}, 4000);
  EXPECT_EQ(tuner.settings().contactSamples, InteractionTuner::kMostSamples);
}

TEST(InteractionTuner, TheContactDistanceFollowsTheClearanceAtWhichContactWorks) {
  const auto tuned = [](double clearance) {
    InteractionTuner tuner(kRadius);
    for (int i = 0; i < 4000; ++i) {
      tuner.observe({Author::Contact, 0.01, clearance});
      tuner.observe({Author::Contact, 0.0, 0.5});  // a failure far away does not count
    }
    return tuner.settings().contactDistance;
  };
  const double between = 0.05 * kRadius;
  EXPECT_NEAR(tuned(between / InteractionTuner::kReach), between, 0.001 * kRadius);
  EXPECT_DOUBLE_EQ(tuned(0.0), InteractionTuner::kLeastDistance * kRadius);
  EXPECT_DOUBLE_EQ(tuned(1.0), InteractionTuner::kMostDistance * kRadius);
}

TEST(InteractionTuner, ChangesOncePerWindowAndNotByWhatContactBrings) {
  InteractionTuner tuner(kRadius);
  const double before = tuner.settings().alpha;
  observe(tuner, {Author::Computer, 0.0, 0.0}, InteractionTuner::kWindow - 1);
  EXPECT_EQ(tuner.settings().alpha, before);
  observe(tuner, {Author::Computer, 0.0, 0.0}, 1);
  EXPECT_LT(tuner.settings().alpha, before);
  const double after = tuner.settings().alpha;
  observe(tuner, {Author::Contact, kNewGround, 0.05}, 5000);
  EXPECT_EQ(tuner.settings().alpha, after);
}

TEST(InteractionTuner, ReportsWhatIsInForceAndItsMedian) {
  InteractionTuner tuner(kRadius);
  const double first = tuner.settings().alpha;
  observe(tuner, {Author::Contact, 0.0, 0.05}, 5000);
  observe(tuner, {Author::Computer, 0.0, 0.0}, 1000);
  EXPECT_DOUBLE_EQ(tuner.report().now.alpha, InteractionTuner::kLeastAlpha);
  EXPECT_DOUBLE_EQ(tuner.report().median.alpha, first);
}

/// A run in front of the closed wall; the hand moves all the time, 5 cm away from it.
class TunedPlanner : public testing::Test {
 protected:
  void run(int tuned, std::uint64_t steps, OperatorUse use = OperatorUse::GuideAndContact) {
    TestHost host(problem, 1);
    EXPECT_TRUE(host.values.set(ParameterId::Tuning, tuned));
    EXPECT_TRUE(host.values.set(ParameterId::Alpha, 0.0));
    EXPECT_TRUE(host.values.set(ParameterId::ContactDistance, 0.2));
    if (held) host.sample = operatorAt(problem, Pose::translation({-0.35, 0.3, 0.2}));
    planner = std::make_unique<InteractiveContactBirrt>(problem, 1, use);
    for (std::uint64_t i = 0; i < steps; ++i) {
      if (held) host.sample->moves = i;
      host.stepsLeft = 1;
      planner->solve(host);
    }
  }

  Problem problem = closedProblem();
  bool held = true;
  std::unique_ptr<InteractiveContactBirrt> planner;
};

TEST_F(TunedPlanner, OnlyWhatIsAskedForSetsItself) {
  run(0, 300);
  EXPECT_FALSE(planner->tuning());
  EXPECT_EQ(planner->counts().randomConfigurations, 0U);  // the user has set alpha = 0
  run(kTunedContactSamples, 300);
  EXPECT_TRUE(planner->tuning());
  EXPECT_EQ(planner->counts().randomConfigurations, 0U);
  EXPECT_GT(planner->counts().contactConfigurations, 0U);
  run(kTunedAlpha, 300);
  EXPECT_GT(planner->counts().randomConfigurations, 0U);
}

TEST_F(TunedPlanner, WithoutAnOperatorNothingSetsItself) {
  run(kTunedAll, 300, OperatorUse::None);
  EXPECT_FALSE(planner->tuning());
  held = false;
  run(kTunedAll, 300);
  EXPECT_DOUBLE_EQ(planner->tuning()->now.alpha, InteractionTuner(1.0).settings().alpha);
}

}  // namespace
}  // namespace glissade
