// Properties of the pipeline from a device to its motion.
#include "engine/operator/device_shaping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/base/random_stream.h"
#include "engine/operator/shaping_presets.h"
#include "tests/engine/operator/operator_support.h"

namespace glissade {
namespace {

AxisShaping randomAxis(RandomStream& stream) {
  AxisShaping axis;
  axis.deadZone = stream.uniform(kDeadZoneRange.lowest, kDeadZoneRange.highest);
  axis.gain = stream.uniform(kGainRange.lowest, kGainRange.highest);
  axis.exponent = stream.uniform(kExponentRange.lowest, kExponentRange.highest);
  return axis;
}

RawAxes randomAxes(RandomStream& stream) {
  RawAxes raw{};
  for (double& axis : raw) axis = stream.uniform(-1.0, 1.0);
  return raw;
}

RawAxes axesOf(const Deflection& deflection) {
  RawAxes axes{};
  for (int i = 0; i < 3; ++i) {
    axes[static_cast<std::size_t>(i)] = deflection.translation[i];
    axes[static_cast<std::size_t>(i) + 3] = deflection.rotation[i];
  }
  return axes;
}

Deflection shapeOnce(const DeviceShaping& shaping, const RawAxes& raw) {
  DominantAxis dominant;
  return shape(shaping, raw, dominant);
}

class ShapeAxis : public testing::Test {
 protected:
  RandomStream stream{1, "shaping"};
};

TEST_F(ShapeAxis, IsMonotoneOddAndInItsRange) {
  for (int trial = 0; trial < 300; ++trial) {
    const AxisShaping axis = randomAxis(stream);
    double before = -1.0;
    for (double raw = -1.2; raw <= 1.2; raw += 0.01) {
      const double now = shapeAxis(axis, raw);
      ASSERT_GE(now, before - 1e-15);
      ASSERT_LE(std::abs(now), 1.0);
      ASSERT_EQ(now, -shapeAxis(axis, -raw));
      before = now;
    }
  }
}

TEST_F(ShapeAxis, TheDeadZoneIsRestAndItsEdgeIsContinuous) {
  for (int trial = 0; trial < 300; ++trial) {
    const AxisShaping axis = randomAxis(stream);
    EXPECT_EQ(shapeAxis(axis, stream.uniform(-axis.deadZone, axis.deadZone)), 0.0);
    EXPECT_EQ(shapeAxis(axis, axis.deadZone), 0.0);
    EXPECT_NEAR(shapeAxis(axis, axis.deadZone + 1e-7), 0.0, 1e-5);
    EXPECT_GT(shapeAxis(axis, 1.0), 0.0);
  }
}

TEST_F(ShapeAxis, ASmallMoveOfTheHandIsASmallChange) {
  for (int trial = 0; trial < 300; ++trial) {
    const AxisShaping axis = randomAxis(stream);
    const double steepest = axis.gain * axis.exponent / (1.0 - axis.deadZone);
    for (double raw = -1.0; raw < 1.0; raw += 0.01) {
      ASSERT_LE(std::abs(shapeAxis(axis, raw + 0.01) - shapeAxis(axis, raw)), 0.0101 * steepest);
    }
  }
}

TEST_F(ShapeAxis, FullDeflectionAtUnitGainIsFullAndInversionTurnsItRound) {
  AxisShaping axis = randomAxis(stream);
  axis.gain = 1.0;
  EXPECT_EQ(shapeAxis(axis, 1.0), 1.0);
  axis.inverted = true;
  EXPECT_EQ(shapeAxis(axis, 1.0), -1.0);
  EXPECT_GT(shapeAxis(axis, -0.9), 0.0);
}

TEST_F(ShapeAxis, WhatIsNoNumberIsRest) {
  EXPECT_EQ(shapeAxis(AxisShaping(), std::numeric_limits<double>::quiet_NaN()), 0.0);
  EXPECT_EQ(shapeAxis(AxisShaping(), std::numeric_limits<double>::infinity()), 1.0);
}

TEST(Shaping, EveryAxisDrivesItsOwnUnlessSwapped) {
  DeviceShaping shaping;
  const RawAxes raw{0.9, 0, 0, 0, -0.8, 0};
  EXPECT_GT(shapeOnce(shaping, raw).translation.x(), 0.8);
  EXPECT_LT(shapeOnce(shaping, raw).rotation.y(), -0.7);
  std::swap(shaping.axes[0].source, shaping.axes[4].source);
  EXPECT_LT(shapeOnce(shaping, raw).translation.x(), -0.7);
  EXPECT_GT(shapeOnce(shaping, raw).rotation.y(), 0.8);
}

TEST(Shaping, LocksHoldTheirAxesAndLeaveTheOthers) {
  RandomStream stream(2, "locks");
  for (int trial = 0; trial < 200; ++trial) {
    const RawAxes raw = randomAxes(stream);
    const Deflection free = shapeOnce(DeviceShaping(), raw);
    DeviceShaping noTurning;
    noTurning.rotationLocked = true;
    DeviceShaping noShifting;
    noShifting.translationLocked = true;
    EXPECT_EQ(shapeOnce(noTurning, raw).translation, free.translation);
    EXPECT_TRUE(shapeOnce(noTurning, raw).rotation.isZero());
    EXPECT_EQ(shapeOnce(noShifting, raw).rotation, free.rotation);
    EXPECT_TRUE(shapeOnce(noShifting, raw).translation.isZero());
  }
}

class Dominant : public testing::Test {
 protected:
  Dominant() { shaping.dominantAxis = true; }
  RawAxes now(const RawAxes& raw) { return axesOf(shape(shaping, raw, dominant)); }

  DeviceShaping shaping;
  DominantAxis dominant;
};

TEST_F(Dominant, AtMostOneAxisMovesAndItIsOneOfTheLargest) {
  RandomStream stream(3, "dominant");
  for (int trial = 0; trial < 2000; ++trial) {
    const RawAxes raw = randomAxes(stream);
    const RawAxes all = axesOf(shapeOnce(DeviceShaping(), raw));
    const RawAxes only = now(raw);
    double largest = 0.0;
    for (const double axis : all) largest = std::max(largest, std::abs(axis));
    int moving = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      if (only[i] == 0.0) continue;
      ++moving;
      EXPECT_EQ(only[i], all[i]);
      EXPECT_GE(std::abs(only[i]) * 1.25, largest);
    }
    EXPECT_EQ(moving, largest > 0.0 ? 1 : 0);
  }
}

TEST_F(Dominant, EqualAxesDoNotFlicker) {
  now({0.6, 0, 0, 0, 0, 0});
  for (int i = 0; i < 100; ++i) {
    const double tremble = i % 2 == 0 ? 0.05 : -0.05;
    EXPECT_NE(now({0.6, 0.6 + tremble, 0, 0, 0, 0})[0], 0.0);
  }
  EXPECT_NE(now({0.6, 0.9, 0, 0, 0, 0})[1], 0.0);
}

TEST_F(Dominant, NoneIsStuck) {
  EXPECT_NE(now({1, 0, 0, 0, 0, 0})[0], 0.0);
  EXPECT_NE(now({0, 0.1, 0, 0, 0, 0})[1], 0.0);
  EXPECT_EQ(now({}), RawAxes{});
  EXPECT_NE(now({0, 0, 0, 0, 0, 0.1})[5], 0.0);
}

TEST_F(Dominant, ALockedAxisNeverDominates) {
  shaping.translationLocked = true;
  EXPECT_NE(now({1, 0, 0, 0.2, 0, 0})[3], 0.0);
}

TEST(ShapedFrame, IsThatOfTheViewTheWorldOrTheObject) {
  OperatorView view = viewOf(Pose::identity());
  view.frame.R_WV = Quaternion(Eigen::AngleAxisd(1.0, Vector3::UnitZ()));
  view.q_device.orientation = Quaternion(Eigen::AngleAxisd(0.5, Vector3::UnitX()));
  DeviceShaping shaping;
  shaping.linearSpeed = 0.5;
  EXPECT_TRUE(shapedFrame(shaping, view).R_WV.isApprox(view.frame.R_WV));
  EXPECT_EQ(shapedFrame(shaping, view).speed.linear, 0.5 * view.frame.speed.linear);
  shaping.frame = MotionFrame::Object;
  EXPECT_TRUE(shapedFrame(shaping, view).R_WV.isApprox(view.q_device.orientation));
  shaping.frame = MotionFrame::World;
  const Quaternion R_WD = shapedFrame(shaping, view).R_WV;
  EXPECT_TRUE((R_WD * Vector3::UnitX()).isApprox(Vector3::UnitX()));
  EXPECT_TRUE((R_WD * Vector3::UnitY()).isApprox(Vector3::UnitZ(), 1e-12));
  EXPECT_TRUE((R_WD * Vector3::UnitZ()).isApprox(-Vector3::UnitY(), 1e-12));
}

TEST(OperatorSpeed, FollowsTheZoomWithinWhatSuitsTheObject) {
  EXPECT_NEAR(operatorSpeed(4.0, 0.5).linear, 2.0 * operatorSpeed(2.0, 0.5).linear, 1e-12);
  EXPECT_GT(operatorSpeed(1e-6, 0.5).linear, 0.0);
  EXPECT_LE(operatorSpeed(1e6, 0.5).linear, 2.5);
}

TEST(InRange, BringsEveryValueBack) {
  DeviceShaping wild;
  wild.axes[2] = {17, -3.0, std::numeric_limits<double>::quiet_NaN(), 100.0, true};
  wild.linearSpeed = std::numeric_limits<double>::infinity();
  wild.angularSpeed = -1.0;
  const DeviceShaping tame = inRange(wild);
  EXPECT_EQ(tame.axes[2], (AxisShaping{2, kDeadZoneRange.lowest, 1.0, kExponentRange.highest, true}));
  EXPECT_EQ(tame.linearSpeed, 1.0);
  EXPECT_EQ(tame.angularSpeed, kSpeedRange.lowest);
}

TEST(Presets, AreInRangeAndDiffer) {
  for (const InputKind kind : {InputKind::Keyboard, InputKind::Mouse6D, InputKind::Gamepad}) {
    const auto presets = shapingPresets(kind);
    ASSERT_FALSE(presets.empty());
    EXPECT_EQ(presets.front().shaping, standardShaping(kind));
    for (std::size_t i = 0; i < presets.size(); ++i) {
      EXPECT_EQ(inRange(presets[i].shaping), presets[i].shaping) << presets[i].id;
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(presets[i].shaping == presets[j].shaping);
    }
  }
}

}  // namespace
}  // namespace glissade
