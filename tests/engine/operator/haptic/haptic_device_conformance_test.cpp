// Every haptic device keeps the same contract.
#include "tests/engine/operator/haptic/haptic_device_conformance.h"

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "tests/engine/support/random_pose.h"

namespace glissade {
namespace {

class HapticDeviceConformance : public testing::TestWithParam<HapticDeviceUnderTest> {};

TEST_P(HapticDeviceConformance, StaysFiniteUnderAnyWrench) {
  const auto device = GetParam().make();
  const HapticLimits limits = device->limits();
  ASSERT_GT(limits.force, 0.0);
  ASSERT_GT(limits.torque, 0.0);
  device->place(Pose());
  RandomStream stream(1, "wrenches");
  for (int i = 0; i < 5000; ++i) {
    const auto any = [&] { return Vector3(stream.uniform(-1, 1), stream.uniform(-1, 1), stream.uniform(-1, 1)); };
    device->render({limits.force * any().normalized(), limits.torque * any().normalized()});
    const HapticState state = device->advance(1e-3);
    ASSERT_TRUE(isValid(state.X_WD));
    ASSERT_TRUE(state.V_WD.linear_W.allFinite() && state.V_WD.angular_W.allFinite());
  }
}

TEST_P(HapticDeviceConformance, IsWhereItWasPlaced) {
  const auto device = GetParam().make();
  RandomStream stream(2, "poses");
  for (int i = 0; i < 20; ++i) {
    const Pose q = randomPose(stream, 2.0);
    device->place(q);
    const HapticState state = device->advance(0.0);
    EXPECT_EQ(state.X_WD, q);
    EXPECT_TRUE(state.V_WD.atRest());
  }
}

TEST_P(HapticDeviceConformance, ItsVelocityIsThatOfItsPose) {
  const auto device = GetParam().make();
  device->place(Pose());
  Pose last = device->advance(0.0).X_WD;
  for (int i = 0; i < 1000; ++i) {
    const HapticState state = device->advance(1e-3);
    EXPECT_LT((state.X_WD.position - last.position - 1e-3 * state.V_WD.linear_W).norm(), 1e-6);
    EXPECT_LT((rotationVector(last.orientation, state.X_WD.orientation) - 1e-3 * state.V_WD.angular_W).norm(), 1e-6);
    last = state.X_WD;
  }
}

TEST_P(HapticDeviceConformance, GivesWayToAForce) {
  const auto free = GetParam().make();
  const auto pushed = GetParam().make();
  free->place(Pose());
  pushed->place(Pose());
  for (int i = 0; i < 100; ++i) {
    pushed->render({{0.0, 0.0, 0.5 * pushed->limits().force}, Vector3::Zero()});
    free->advance(1e-3);
    pushed->advance(1e-3);
  }
  EXPECT_GT(pushed->advance(1e-3).X_WD.position.z(), free->advance(1e-3).X_WD.position.z());
}

INSTANTIATE_TEST_SUITE_P(Devices, HapticDeviceConformance, testing::ValuesIn(hapticDevicesUnderTest()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace glissade
