// Every device of the registry keeps the same contract.
#include "tests/engine/operator/device_conformance.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/operator/operator_support.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

class DeviceConformance : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<OperatorDevice> make() const {
    DeviceContext context;
    context.route = {Pose::translation({1, 0, 0}), Pose::translation({20, 0, 0})};
    context.metric = Se3Metric(1.0);
    context.hand = std::make_shared<HandInputs>();
    context.world = windowProblem().world;
    return devicesUnderTest().registry.find(GetParam())->make(context);
  }
};

TEST_P(DeviceConformance, StaysValidAndInTheRoomWhateverTheClockDoes) {
  const auto device = make();
  ASSERT_NE(device, nullptr);
  RandomStream stream(1, "clock");
  Pose q;
  for (int i = 0; i < 2000; ++i) {
    q = device->advance(stream.uniform(0.0, 0.2), viewOf(q), kRoom);
    ASSERT_TRUE(isValid(q));
    ASSERT_TRUE(kRoom.contains(q.position));
  }
}

TEST_P(DeviceConformance, NoTimeNoMotion) {
  const auto device = make();
  RandomStream stream(2, "poses");
  for (int i = 0; i < 20; ++i) {
    const Pose q = randomPose(stream, 2.0);
    EXPECT_EQ(device->advance(0.0, viewOf(q), kRoom), q);
  }
}

TEST_P(DeviceConformance, RestartsAsNew) {
  const auto device = make();
  const auto fresh = make();
  Pose q;
  for (int i = 0; i < 100; ++i) q = device->advance(0.025, viewOf(q), kRoom);
  device->restart();
  EXPECT_TRUE(isValid(device->advance(0.025, viewOf(Pose::identity()), kRoom)));
  EXPECT_TRUE(isValid(fresh->advance(0.025, viewOf(Pose::identity()), kRoom)));
}

TEST_P(DeviceConformance, SameSeedAndCallsGiveTheSameMotion) {
  const auto a = make();
  const auto b = make();
  Pose qa;
  Pose qb;
  for (int i = 0; i < 500; ++i) {
    qa = a->advance(0.025, viewOf(qa), kRoom);
    qb = b->advance(0.025, viewOf(qb), kRoom);
    ASSERT_EQ(qa, qb);
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, DeviceConformance, testing::ValuesIn(devicesUnderTest().ids),
                         [](const testing::TestParamInfo<std::string>& parameter) {
                           std::string name = parameter.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace glissade
