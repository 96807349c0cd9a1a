#include <gtest/gtest.h>

#include "engine/operator/haptic/simulated_haptic_device.h"
#include "tests/engine/operator/haptic/haptic_device_conformance.h"

namespace glissade {
namespace {

std::unique_ptr<HapticDevice> simulated(double radius) {
  return std::make_unique<SimulatedHapticDevice>(
      alongRoute({Pose::translation({radius, 0, 0}), Pose{{0, radius, 0}, fromRollPitchYaw(1, 0, 0)}},
                 Se3Metric(radius), radius),
      radius);
}

}  // namespace

/// Every haptic device of the product.
std::vector<HapticDeviceUnderTest> hapticDevicesUnderTest() {
  return {{"Simulated", [] { return simulated(1.5); }},
          {"SimulatedWatch", [] { return simulated(0.01); }},
          {"SimulatedShip", [] { return simulated(100.0); }}};
}

namespace {

TEST(AlongRoute, BeginsAtTheBeginAndRestsAtTheEnd) {
  const HandMotion motion =
      alongRoute({Pose::translation({1, 0, 0}), Pose::translation({1, 1, 0})}, Se3Metric(1.0), 0.5);
  const Pose begin = Pose::translation({-1, 0, 0});
  EXPECT_EQ(motion(0.0, begin), begin);
  EXPECT_TRUE(motion(2.0, begin).position.isApprox(Vector3(0, 0, 0), 1e-12));
  EXPECT_TRUE(motion(5.0, begin).position.isApprox(Vector3(1, 0.5, 0), 1e-12));
  EXPECT_TRUE(motion(99.0, begin).position.isApprox(Vector3(1, 1, 0), 1e-12));
}

}  // namespace
}  // namespace glissade
