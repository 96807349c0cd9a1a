#include "engine/sequence/step_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/sequence/fasteners.h"
#include "engine/sequence/sequence_run.h"
#include "engine/sequence/solid_mass.h"
#include "engine/sequence/tool_shape.h"
#include "tests/engine/fits/ring.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

TriangleMesh screwMesh() {
  TriangleMesh mesh = test::makeRing(0.0, 0.004, 0.04, 24);
  append(mesh, transformed(test::makeRing(0.0, 0.007, 0.008, 24), Pose::translation({0.0, 0.0, 0.024})));
  return mesh;
}

/// A screw in a plate, head up, and a tube about the head that is higher than tools with a handle.
AssembledProduct screwInTube() {
  RigidBody plate = boxBody("plate", {0.2, 0.2, 0.02}, Pose::identity());
  plate.mesh = std::make_shared<const TriangleMesh>(test::makeRing(0.004, 0.1, 0.02, 24));
  RigidBody screw = boxBody("screw", {1.0, 1.0, 1.0}, Pose::translation({0.0, 0.0, -0.01}));
  screw.mesh = std::make_shared<const TriangleMesh>(screwMesh());
  RigidBody tube = boxBody("tube", {1.0, 1.0, 1.0}, Pose::translation({0.0, 0.0, 0.06}));
  tube.mesh = std::make_shared<const TriangleMesh>(test::makeRing(0.02, 0.03, 0.1, 24));
  return test::productOf({plate, screw, tube}, true);
}

AssemblyPlan planWith(const AssembledProduct& product, const SequenceDemands& demands) {
  test::QuietHost host;
  auto plan = planSequence(product, test::fitsOf(product), {{true, false, false}, "greedy", 1, demands}, host);
  EXPECT_TRUE(plan.ok());
  return std::move(*plan);
}

const StepTool& toolIn(const AssemblyPlan& plan, const BodyId& body) {
  const auto isOfBody = [&](const AssemblyStep& step) { return step.only().body == body; };
  return std::find_if(plan.steps.begin(), plan.steps.end(), isOfBody)->only().tool;
}

TEST(StepTools, AHandleIsBlockedWhileATubeIsAboutTheHead) {
  SequenceDemands screwFirst;
  screwFirst.before = {{"screw", "tube"}};
  const AssembledProduct product = screwInTube();
  const AssemblyPlan blocked = planWith(product, screwFirst);
  ASSERT_EQ(blocked.steps.size(), 2U);
  const StepTool& tool = toolIn(blocked, "screw");
  EXPECT_EQ(tool.kind, ToolKind::HexKey) << "the head is as high as a socket head";
  EXPECT_EQ(tool.access, ToolAccess::Blocked);
  EXPECT_EQ(tool.blockedBy, std::vector<BodyId>{"tube"});
  SequenceDemands tubeFirst;
  tubeFirst.before = {{"tube", "screw"}};
  const AssemblyPlan open = planWith(product, tubeFirst);
  EXPECT_EQ(toolIn(open, "screw").access, ToolAccess::Free);
  EXPECT_EQ(toolIn(open, "tube").kind, ToolKind::None);
}

TEST(StepTools, WhatABodyNeedsIsAsked) {
  const AssembledProduct product = screwInTube();
  const auto toolOf = [&](const std::string& name) {
    SequenceDemands demands;
    demands.before = {{"screw", "tube"}};
    demands.tools = {{"screw", name}};
    return toolIn(planWith(product, demands), "screw");
  };
  EXPECT_EQ(toolOf("screwdriver").access, ToolAccess::Free) << "it has no handle to the side";
  EXPECT_EQ(toolOf("open_wrench").access, ToolAccess::Blocked);
  SequenceDemands tubeFirst;
  tubeFirst.before = {{"tube", "screw"}};
  tubeFirst.tools = {{"screw", "open_wrench"}};
  EXPECT_EQ(toolIn(planWith(product, tubeFirst), "screw").access, ToolAccess::Free);
  EXPECT_EQ(toolOf("none").kind, ToolKind::None);
}

TEST(StepTools, RefusesAnUnknownTool) {
  SequenceDemands demands;
  demands.tools = {{"screw", "hammer"}};
  const AssembledProduct product = screwInTube();
  test::QuietHost host;
  const auto plan = planSequence(product, test::fitsOf(product), {{true, false, false}, "greedy", 1, demands}, host);
  ASSERT_FALSE(plan.ok());
  EXPECT_NE(toString(plan.error().reason).find("hammer"), std::string::npos);
}

TEST(FastenerHead, IsAtTheHeadsOuterEnd) {
  const auto head = headOf(screwMesh());
  ASSERT_TRUE(head);
  EXPECT_NEAR((head->end - Vector3(0.0, 0.0, 0.028)).norm(), 0.0, 1e-4);
  EXPECT_NEAR(head->outwards.z(), 1.0, 1e-6);
  EXPECT_NEAR(head->radius, 0.007, 1e-4);
  EXPECT_NEAR(head->shaft, 0.004, 1e-4);
  EXPECT_NEAR(head->height, 0.008, 1e-4);
}

TEST(ToolShape, EveryToolIsMadeOfClosedSolidsTurnedOutwards) {
  const FastenerHead head{Vector3::Zero(), Vector3::UnitZ(), 0.007, 0.006, 0.004, 6, DriveKind::None, false};
  for (const ToolKind kind : {ToolKind::HexKey, ToolKind::Socket, ToolKind::Screwdriver, ToolKind::OpenWrench}) {
    const TriangleMesh mesh = toolShape(kind, head);
    EXPECT_GT(solidMass(mesh).volume, 0.0) << kToolNames.of(kind);
  }
  ASSERT_EQ(takeOffWays(ToolKind::Socket, head).size(), 1U);
  EXPECT_GT(takeOffWays(ToolKind::Socket, head).front().z(), head.height);
}

TEST(ToolShape, AnOpenWrenchLeavesTheHeadToTheSideOfItsArm) {
  const FastenerHead head{Vector3::Zero(), Vector3::UnitZ(), 0.007, 0.006, 0.004, 6, DriveKind::None, false};
  const auto wrench = enteringToolShape(ToolKind::OpenWrench, head);
  ASSERT_TRUE(wrench);
  EXPECT_GT(solidMass(*wrench).volume, 0.0);
  EXPECT_FALSE(enteringToolShape(ToolKind::Socket, head));
  const Vector3 way = takeOffWays(ToolKind::OpenWrench, head).front();
  ASSERT_EQ(way.z(), 0.0);
  for (const auto& triangle : wrench->triangles) {
    for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
      const Vector3 on = wrench->vertices[triangle[0]] * (1.0 - share) +
                         0.5 * share * (wrench->vertices[triangle[1]] + wrench->vertices[triangle[2]]);
      // In the frame of the wrench, the head moves from the origin against the motion.
      const double along = std::clamp(-on.dot(way) / way.squaredNorm(), 0.0, 1.0);
      const Vector3 nearest = -along * way;
      EXPECT_GE((on - nearest).head<2>().norm(), head.radius) << on.transpose();
    }
  }
}

}  // namespace
}  // namespace glissade
