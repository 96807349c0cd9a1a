#include "engine/operator/recorded_device.h"

#include <gtest/gtest.h>

#include "tests/engine/operator/operator_support.h"

namespace glissade {
namespace {

TEST(RecordedDevice, GivesThePoseInForceAtEachStep) {
  const Pose a = Pose::translation({1, 0, 0});
  const Pose b = Pose::translation({2, 0, 0});
  RecordedDevice device({{0, Pose::identity()}, {2, a}, {5, b}});
  Pose q;
  std::vector<double> seen;
  for (int step = 1; step <= 6; ++step) {
    q = device.advance(0.025, viewOf(q), kRoom);
    seen.push_back(q.position.x());
  }
  EXPECT_EQ(seen, (std::vector<double>{0, 1, 1, 1, 2, 2}));
  device.restart();
  EXPECT_EQ(device.advance(0.025, viewOf(Pose::identity()), kRoom), Pose::identity());
}

}  // namespace
}  // namespace glissade
