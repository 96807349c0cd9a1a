#include "engine/documents/plan_tasks.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

std::vector<AssemblyStep> stepsOfTasks(const std::vector<std::size_t>& tasks) {
  std::vector<AssemblyStep> steps;
  for (const std::size_t task : tasks) {
    steps.push_back({{StepMotion()}});
    steps.back().only().body = BodyId("body" + std::to_string(steps.size()));
    steps.back().task = task;
  }
  return steps;
}

TEST(PlanTasks, StepsOfOneTaskThatFollowEachOtherAreTogether) {
  EXPECT_EQ(taskRanges(stepsOfTasks({0, 0, 7, 7, 7, 2}), {}), (std::vector<TaskRange>{{0, 1}, {1, 3}, {4, 1}, {5, 1}}))
      << "the plan is in the order of removal";
  EXPECT_TRUE(taskRanges({}, {}).empty());
}

TEST(PlanTasks, AlikePartsThatComeInTheSameWayAreTogether) {
  auto steps = stepsOfTasks({0, 0, 0, 0});
  const auto leave = [](AssemblyStep& step, const Vector3& way) {
    step.only().path = {{Pose::identity(), Author::Computer}, {Pose::translation(way), Author::Computer}};
  };
  for (AssemblyStep& step : steps) leave(step, Vector3::UnitZ());
  PartsListRow alike;
  alike.bodies = {"body1", "body2", "body3"};
  EXPECT_EQ(taskRanges(steps, {alike}), (std::vector<TaskRange>{{0, 1}, {1, 3}}));
  leave(steps[1], Vector3::UnitX());
  EXPECT_EQ(taskRanges(steps, {alike}).size(), 4U) << "another direction";
  leave(steps[1], Vector3::UnitZ());
  steps[0].only().joints.push_back({JointKind::Pin, "body1", {}});
  EXPECT_EQ(taskRanges(steps, {alike}), (std::vector<TaskRange>{{0, 1}, {1, 2}, {3, 1}})) << "another joint";
}

TEST(PlanTasks, AGroupIsATaskAlone) {
  auto steps = stepsOfTasks({7, 7, 7});
  steps[1].only().with = {"other"};
  EXPECT_EQ(taskRanges(steps, {}).size(), 3U);
}

TEST(PlanTasks, NumbersAreThoseOfTheOrderOfAssembly) {
  const auto steps = stepsOfTasks({0, 0, 0});
  EXPECT_EQ(stepAtPlace(steps, 0).only().body, "body3");
  EXPECT_EQ(taskNumber({2, 1}), "3");
  EXPECT_EQ(taskNumber({2, 4}), "3–6");
  EXPECT_EQ(taskNumber({0, 2}, "12"), "12.1–12.2");
}

}  // namespace
}  // namespace glissade
