#include "engine/sequence/work_times.h"

#include <gtest/gtest.h>

#include "engine/geometry/primitives.h"

namespace glissade {
namespace {

RigidBody cube(const BodyId& id, double edge) {
  RigidBody body;
  body.id = id;
  body.mesh = std::make_shared<const TriangleMesh>(makeBox(Vector3::Constant(edge)));
  return body;
}

AssemblyStep stepOf(const BodyId& body) {
  AssemblyStep step{{StepMotion()}};
  step.only().body = body;
  step.only().path.resize(2);
  return step;
}

struct WorkTimesTest : ::testing::Test {
  AssembledProduct product{{cube("tiny", 0.004), cube("part", 0.05), cube("wide", 0.4), cube("heavy", 0.13)}, {}, {}};
  AssemblyPlan plan;
  WorkTimes times;

  double totalOf(const AssemblyStep& step) {
    plan.steps = {step};
    return stepTimes(plan, product, times)[0].total();
  }
};

TEST_F(WorkTimesTest, FetchBySizeAndWeight) {
  plan.demands.masses = {{"wide", 1.0}};
  EXPECT_DOUBLE_EQ(totalOf(stepOf("part")), times.fetch + times.place);
  EXPECT_DOUBLE_EQ(totalOf(stepOf("tiny")), times.fetchSmall + times.place);
  EXPECT_DOUBLE_EQ(totalOf(stepOf("wide")), times.fetchLarge + times.place);
  EXPECT_DOUBLE_EQ(totalOf(stepOf("heavy")), times.fetchWithAid + times.place);
  plan.demands.masses = {{"heavy", 5.0}};
  EXPECT_DOUBLE_EQ(totalOf(stepOf("heavy")), times.fetchLarge + times.place);
}

TEST_F(WorkTimesTest, PlaceByTheWay) {
  AssemblyStep step = stepOf("part");
  step.only().allowances.emplace_back().body = "wide";
  EXPECT_DOUBLE_EQ(totalOf(step), times.fetch + times.placeAligned);
  step.only().path.resize(3);
  EXPECT_DOUBLE_EQ(totalOf(step), times.fetch + times.placeLed);
}

TEST_F(WorkTimesTest, JointsTakeTheirTime) {
  AssemblyStep screw = stepOf("part");
  screw.only().joints.push_back({JointKind::Screw, "part"});
  screw.only().joints[0].turns = 9.5;
  EXPECT_DOUBLE_EQ(totalOf(screw), times.fetch + times.place + times.startThread + 9.5 * times.turnByHand);
  screw.only().tool.kind = ToolKind::HexKey;
  EXPECT_DOUBLE_EQ(totalOf(screw), times.fetch + times.place + times.startThread + 9.5 * times.turn + times.toolChange);
  AssemblyStep insert = stepOf("part");
  insert.only().joints.push_back({JointKind::Insert, "part"});
  EXPECT_DOUBLE_EQ(totalOf(insert), times.fetch + times.press);
  AssemblyStep belt = stepOf("part");
  belt.only().joints.push_back({JointKind::Flexible, "part"});
  EXPECT_DOUBLE_EQ(totalOf(belt), times.fetch + times.lay);
}

/// Steps are removals; in assembly the last one is the first.
TEST_F(WorkTimesTest, AToolIsTakenOnceForStepsThatFollowEachOther) {
  for (int i = 0; i < 3; ++i) plan.steps.push_back(stepOf("part"));
  plan.steps[2].only().tool.kind = plan.steps[1].only().tool.kind = ToolKind::HexKey;
  plan.steps[0].only().tool.kind = ToolKind::Socket;
  plan.steps[0].only().falling = {"tiny", "wide"};
  const auto all = stepTimes(plan, product, times);
  EXPECT_DOUBLE_EQ(all[2].tool, times.toolChange);
  EXPECT_DOUBLE_EQ(all[1].tool, 0.0);
  EXPECT_DOUBLE_EQ(all[0].tool, times.toolChange);
  EXPECT_DOUBLE_EQ(all[0].hold, 2.0 * times.hold);
}

TEST(WorkTimeRows, AreEachValueOnce) {
  WorkTimes counted;
  for (const WorkTimeRow& row : workTimeRows()) {
    EXPECT_GT(counted.*row.value, 0.0) << row.id;
    EXPECT_LE(counted.*row.value, row.most) << row.id;
    counted.*row.value = 0.0;
  }
  EXPECT_EQ(workTimeRows().size() * sizeof(double), sizeof(WorkTimes));
}

}  // namespace
}  // namespace glissade
