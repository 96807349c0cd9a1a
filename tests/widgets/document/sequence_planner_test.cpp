#include "widgets/document/sequence_planner.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QEventLoop>
#include <QTimer>

#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

class SequencePlannerTest : public ::testing::Test {
 protected:
  SequencePlannerTest() {
    QObject::connect(&planner, &SequencePlanner::grown, [this](const GrownPlan& plan) { grown.push_back(plan); });
    QObject::connect(&planner, &SequencePlanner::planned, [this](const GrownPlan& plan) { planned.push_back(plan); });
    QObject::connect(&planner, &SequencePlanner::judged,
                     [this](const PlanPtr&, const PlanCheck& check) { judged.push_back(check.steps); });
  }

  SequenceJob drawer() const {
    SequenceJob job;
    job.product = std::make_shared<const AssembledProduct>(test::lockedDrawer());
    job.staying = BodySet(job.product->bodies.size(), false);
    job.staying[job.product->indexOf("cabinet")] = true;
    return job;
  }

  /// Waits until the task has ended, for at most 10 seconds.
  void waitForTheEnd() {
    if (!planner.task().isBusy()) return;
    QEventLoop loop;
    QObject::connect(&planner.task(), &BackgroundTask::ended, &loop, &QEventLoop::quit);
    QTimer::singleShot(10000, &loop, &QEventLoop::quit);
    loop.exec();
    QCoreApplication::processEvents();
  }

  SequencePlanner planner{std::make_shared<ProductFinder>()};
  std::vector<GrownPlan> grown;
  std::vector<GrownPlan> planned;
  std::vector<std::vector<StepCheck>> judged;
};

TEST_F(SequencePlannerTest, StepsAreAnnouncedWhileTheyAreFoundOnAWorkerAndAtOnceAlike) {
  planner.plan(drawer(), true);
  ASSERT_EQ(planned.size(), 1U);
  const PlanPtr atOnce = planned[0].plan;
  EXPECT_EQ(test::orderOf(*atOnce), (std::vector<BodyId>{"cap", "pin", "drawer"}));
  EXPECT_EQ(planned[0].foundAfter.size(), 3U);
  EXPECT_GE(grown.size(), 3U) << "three waves";
  planner.plan(drawer(), false);
  EXPECT_TRUE(planner.isPlanning());
  waitForTheEnd();
  ASSERT_EQ(planned.size(), 2U);
  EXPECT_EQ(test::orderOf(*planned[1].plan), test::orderOf(*atOnce));
  EXPECT_FALSE(planner.isPlanning());
}

TEST_F(SequencePlannerTest, WhatIsThereIsKeptWhenPlanningStopsAndGoesOnFromThere) {
  SequenceJob job = drawer();
  job.mostSteps = 1;
  planner.plan(job, false);
  waitForTheEnd();
  ASSERT_EQ(planned.size(), 1U);
  EXPECT_EQ(planned[0].plan->steps.size(), 1U);
  EXPECT_EQ(planned[0].plan->end, PlanEnd::Interrupted);
  job.mostSteps.reset();
  job.resumed = planned[0].plan;
  planner.plan(job, false);
  waitForTheEnd();
  ASSERT_EQ(planned.size(), 2U);
  EXPECT_EQ(planned[1].plan->steps.size(), 3U);
  EXPECT_EQ(planned[1].foundAfter.size(), 2U) << "of the steps that are new";
}

TEST_F(SequencePlannerTest, AStopEndsPlanningAndDroppingAnnouncesNothing) {
  planner.plan(drawer(), false);
  planner.stop();
  waitForTheEnd();
  EXPECT_LE(planned.size(), 1U) << "none where the stop came before the first step";
  const std::size_t before = planned.size() + grown.size();
  planner.plan(drawer(), false);
  planner.drop();
  QCoreApplication::processEvents();
  EXPECT_EQ(planned.size() + grown.size(), before);
  EXPECT_FALSE(planner.isPlanning());
}

TEST_F(SequencePlannerTest, StepsThatDoNotHoldAreFound) {
  const SequenceJob job = drawer();
  planner.plan(job, true);
  AssemblyPlan wrong = *planned[0].plan;
  std::swap(wrong.steps[1], wrong.steps[2]);
  for (AssemblyStep& step : wrong.steps) step.after.clear();
  planner.judge(job.product, planned[0].plan, {}, false);
  waitForTheEnd();
  planner.judge(job.product, std::make_shared<const AssemblyPlan>(wrong), {}, false);
  waitForTheEnd();
  ASSERT_EQ(judged.size(), 2U);
  EXPECT_EQ(judged[0], std::vector<StepCheck>(3, StepCheck::Agrees));
  EXPECT_EQ(judged[1][1], StepCheck::Disagrees) << "the drawer through its pin";
}

}  // namespace
}  // namespace glissade
