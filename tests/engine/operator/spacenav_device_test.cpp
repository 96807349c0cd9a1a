// The real libspnav against a fake daemon on a socket.
#include "engine/operator/spacenav_device.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <climits>
#include <cstdlib>
#include <functional>
#include <thread>

#include "tests/engine/operator/fake_spacenav_daemon.h"
#include "tests/engine/operator/operator_support.h"

namespace glissade {
namespace {

using std::chrono::milliseconds;

class Spacenav : public testing::Test {
 protected:
  void SetUp() override {
    socket = testing::TempDir() + "glissade-spnav-" + std::to_string(::getpid()) + ".sock";
    setenv("SPNAV_SOCKET", socket.c_str(), 1);
  }
  void TearDown() override { unsetenv("SPNAV_SOCKET"); }

  static bool eventually(const std::function<bool()>& condition, milliseconds patience = milliseconds(15000)) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (!condition() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(milliseconds(5));
    return condition();
  }
  static Vector3 moved(SpacenavDevice& device) { return device.advance(0.1, viewOf(Pose::identity()), kRoom).position; }

  std::string socket;
};

TEST_F(Spacenav, TheLastDeflectionCountsAndSilenceIsRest) {
  FakeSpacenavDaemon daemon(socket);
  SpacenavDevice device;
  ASSERT_TRUE(eventually([&] { return device.connected() && daemon.hasClient(); }));
  for (int i = 0; i < 100; ++i) daemon.sendMotion(i, 0, 0);
  daemon.sendMotion(350, 0, -350);
  ASSERT_TRUE(eventually([&] { return moved(device).x() > 0.099; }));
  daemon.sendMotion(350, 0, -350);
  EXPECT_TRUE(eventually([&] { return moved(device).isApprox(Vector3(0.1, 0, 0.1), 1e-9); }));
  // Nothing more comes: the puck was let go somewhere else.
  EXPECT_TRUE(eventually([&] { return moved(device).isZero(); }));
}

TEST_F(Spacenav, SmallDeflectionsAreRestAndHugeOnesAreFull) {
  FakeSpacenavDaemon daemon(socket);
  SpacenavDevice device;
  ASSERT_TRUE(eventually([&] { return device.connected(); }));
  daemon.sendMotion(INT_MAX, 5, INT_MIN);
  EXPECT_TRUE(eventually([&] { return moved(device).isApprox(Vector3(0.1, 0, 0.1), 1e-9); }));
}

TEST_F(Spacenav, ComesBackAfterTheDaemonDied) {
  auto daemon = std::make_unique<FakeSpacenavDaemon>(socket);
  SpacenavDevice device;
  ASSERT_TRUE(eventually([&] { return device.connected(); }));
  daemon.reset();
  ASSERT_TRUE(eventually([&] { return !device.connected(); }));
  EXPECT_TRUE(eventually([&] { return moved(device).isZero(); }));
  daemon = std::make_unique<FakeSpacenavDaemon>(socket);
  ASSERT_TRUE(eventually([&] { return device.connected() && daemon->hasClient(); }));
  daemon->sendMotion(0, 350, 0);
  EXPECT_TRUE(eventually([&] { return moved(device).y() > 0.099; }));
}

TEST_F(Spacenav, WithoutADaemonNothingBlocks) {
  SpacenavDevice device;
  EXPECT_FALSE(device.connected());
  EXPECT_TRUE(moved(device).isZero());
}

TEST_F(Spacenav, ADaemonThatNeverAcceptsBlocksNobody) {
  FakeSpacenavDaemon daemon(socket, false);
  SpacenavDevice device;
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(moved(device).isZero());
}

TEST_F(Spacenav, GarbageAndHalfPacketsDoNoHarm) {
  FakeSpacenavDaemon daemon(socket);
  SpacenavDevice device;
  ASSERT_TRUE(eventually([&] { return device.connected(); }));
  std::vector<unsigned char> garbage(1000);
  for (std::size_t i = 0; i < garbage.size(); ++i) garbage[i] = static_cast<unsigned char>(i * 37);
  daemon.sendBytes(garbage);
  for (int i = 0; i < 100; ++i) {
    const Pose q = device.advance(0.01, viewOf(Pose::identity()), kRoom);
    ASSERT_TRUE(isValid(q));
  }
}

}  // namespace
}  // namespace glissade
