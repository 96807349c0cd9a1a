#include "engine/sequence/tool_choice.h"

#include <gtest/gtest.h>

#include "tests/engine/fits/turned_parts.h"
#include "tests/engine/sequence/products.h"

namespace glissade {
namespace {

using Tools = std::vector<ToolUse>;

const std::vector<FastenerKind> kKinds{FastenerKind::None, FastenerKind::Screw, FastenerKind::Nut};

AssembledProduct plateBoltAndNut() {
  return test::productOf({boxBody("plate", {1.0, 1.0, 0.1}, Pose::identity()),
                          boxBody("bolt", {0.1, 0.1, 0.5}, Pose::translation({2.0, 0.0, 0.0})),
                          boxBody("nut", {0.2, 0.2, 0.1}, Pose::translation({4.0, 0.0, 0.0}))});
}

Joint fastener(JointKind kind, std::size_t body, std::vector<std::size_t> others, DriveKind drive) {
  Joint joint;
  joint.kind = kind;
  joint.body = body;
  joint.others = std::move(others);
  joint.drive = drive;
  return joint;
}

ToolChoices toolsOf(const Joints& joints, const SequenceDemands& demands = {}) {
  const AssembledProduct product = plateBoltAndNut();
  auto tools = chooseTools(ProductShapes(product), kKinds, joints, demands);
  EXPECT_TRUE(tools.ok());
  return std::move(*tools);
}

TEST(ToolChoice, ANutComesOffByItsOwnToolOrByThatOfItsBolt) {
  EXPECT_FALSE(toolsOf({})[1].empty()) << "without joints its shape counts";
  const ToolChoices tools = toolsOf({fastener(JointKind::Nut, 2, {1}, DriveKind::None)});
  EXPECT_EQ(tools[1], (Tools{{ToolKind::Screwdriver, 1}}));
  EXPECT_EQ(tools[2], (Tools{{ToolKind::Socket, 2}, {ToolKind::OpenWrench, 2}, {ToolKind::Screwdriver, 1}}))
      << "its shape, and the bolt's while the nut is held";
}

TEST(ToolChoice, TheDriveOfAJointCountsBeforeTheShape) {
  for (const auto& [drive, tool] :
       {std::pair{DriveKind::HexOutside, ToolKind::Socket}, std::pair{DriveKind::HexSocket, ToolKind::HexKey},
        std::pair{DriveKind::Cross, ToolKind::Screwdriver}, std::pair{DriveKind::Slot, ToolKind::Screwdriver},
        std::pair{DriveKind::SixLobe, ToolKind::Screwdriver}}) {
    const ToolChoices tools = toolsOf({fastener(JointKind::Screw, 1, {0}, drive)});
    ASSERT_FALSE(tools[1].empty());
    EXPECT_EQ(tools[1].front().kind, tool) << kDriveNames.of(drive);
  }
  EXPECT_EQ(toolsOf({fastener(JointKind::Screw, 1, {0}, DriveKind::None)}), toolsOf({})) << "no drive is known";
}

TEST(ToolChoice, NoToolIsNamedForASmoothRoundHead) {
  constexpr double kDiameter = 0.005;
  const auto toolsOfHead = [](double height) {
    RigidBody screw = boxBody("screw", {0.1, 0.1, 0.1}, Pose::identity());
    screw.mesh = std::make_shared<const TriangleMesh>(
        test::screwMesh(kDiameter, 0.02, test::circle(0.9 * kDiameter), height, {}));
    const AssembledProduct product = test::productOf({screw});
    return chooseTools(ProductShapes(product), {FastenerKind::Screw}, {}, {})->front();
  };
  EXPECT_TRUE(toolsOfHead(0.6 * kDiameter).empty());
  EXPECT_EQ(toolsOfHead(kDiameter), (Tools{{ToolKind::HexKey, 0}})) << "as high as a socket head screw";
}

TEST(ToolChoice, APersonsWordCountsFirst) {
  SequenceDemands demands;
  demands.tools = {{"bolt", "hex_key"}};
  EXPECT_EQ(toolsOf({fastener(JointKind::Nut, 2, {1}, DriveKind::HexOutside)}, demands)[1],
            (Tools{{ToolKind::HexKey, 1}}));
}

}  // namespace
}  // namespace glissade
