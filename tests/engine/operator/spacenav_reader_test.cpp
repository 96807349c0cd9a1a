// Tests the real libspnav with a fake daemon on a socket.
#include "engine/operator/spacenav_reader.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <climits>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <new>
#include <thread>

#include "tests/engine/operator/fake_spacenav_daemon.h"
#include "tests/engine/operator/process_load.h"

namespace glissade {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

bool eventually(const std::function<bool()>& condition, milliseconds patience = milliseconds(15000)) {
  const auto end = Clock::now() + patience;
  while (!condition() && Clock::now() < end) std::this_thread::sleep_for(milliseconds(2));
  return condition();
}

class Spacenav : public testing::Test {
 protected:
  void SetUp() override {
    socket = testing::TempDir() + "glissade-spnav-" + std::to_string(::getpid()) + ".sock";
    setenv("SPNAV_SOCKET", socket.c_str(), 1);
  }
  void TearDown() override { unsetenv("SPNAV_SOCKET"); }

  InputReading now() const { return hand->mouse6d.mailbox.reading(); }
  bool comes() const {
    return eventually([&] { return now().connected; });
  }
  bool goes() const {
    return eventually([&] { return !now().connected; });
  }

  std::string socket;
  HandInputsPtr hand = std::make_shared<HandInputs>();
};

TEST_F(Spacenav, TheLastDeflectionCountsAndSilenceIsRest) {
  FakeSpacenavDaemon daemon(socket);
  SpacenavReader reader(hand);
  ASSERT_TRUE(comes());
  for (int i = 0; i < 100; ++i) daemon.sendMotion(i, 0, 0);
  daemon.sendMotion(350, 0, -350, 0, 0, 175);
  EXPECT_TRUE(eventually([&] { return now().axes == RawAxes{1, 0, 1, 0, 0, -0.5}; }));
  // No more events come: the puck was released elsewhere.
  EXPECT_TRUE(eventually([&] { return now().atRest(); }));
  EXPECT_TRUE(now().connected);
}

TEST_F(Spacenav, HugeDeflectionsAreFull) {
  FakeSpacenavDaemon daemon(socket);
  SpacenavReader reader(hand);
  ASSERT_TRUE(comes());
  daemon.sendMotion(INT_MAX, 0, INT_MIN);
  EXPECT_TRUE(eventually([&] { return now().axes == RawAxes{1, 0, 1, 0, 0, 0}; }));
}

TEST_F(Spacenav, KnowsTheMouseByItsNameAndSeesItPulledOutAndPluggedIn) {
  FakeSpacenavDaemon daemon(socket);
  SpacenavReader reader(hand);
  ASSERT_TRUE(comes());
  EXPECT_EQ(now().name, "SpaceNavigator");
  daemon.plug(std::nullopt);
  ASSERT_TRUE(goes());
  daemon.plug("3Dconnexion SpaceMouse Pro Wireless");
  ASSERT_TRUE(comes());
  EXPECT_EQ(now().name, "3Dconnexion SpaceMouse Pro Wireless");
}

TEST_F(Spacenav, NoPressIsLost) {
  FakeSpacenavDaemon daemon(socket);
  SpacenavReader reader(hand);
  ASSERT_TRUE(comes());
  for (int i = 0; i < 50; ++i) {
    daemon.sendButton(1, true);
    daemon.sendButton(1, false);
  }
  daemon.sendButton(-5, true);
  EXPECT_TRUE(eventually([&] { return now().presses[1] == 50; }));
}

TEST_F(Spacenav, WithoutADaemonNothingBlocks) {
  SpacenavReader reader(hand);
  EXPECT_FALSE(now().connected);
  EXPECT_TRUE(now().atRest());
}

TEST_F(Spacenav, ADaemonThatNeverAcceptsOrNeverAnswersBlocksNobody) {
  for (const DaemonHabits& habits : {DaemonHabits{false, false}, DaemonHabits{true, false}}) {
    FakeSpacenavDaemon daemon(socket, habits);
    SpacenavReader reader(hand);
    for (int i = 0; i < 1000; ++i) ASSERT_TRUE(now().atRest());
  }
}

TEST_F(Spacenav, AnOldDaemonWithoutAHandshakeIsUnderstood) {
  FakeSpacenavDaemon daemon(socket, {true, false});
  SpacenavReader reader(hand);
  ASSERT_TRUE(comes());
  daemon.sendMotion(350, 0, 0);
  EXPECT_TRUE(eventually([&] { return now().axes[0] == 1.0; }));
}

TEST_F(Spacenav, GarbageEndsTheConnectionAndTheNextOneWorks) {
  FakeSpacenavDaemon daemon(socket);
  SpacenavReader reader(hand, milliseconds(5));
  ASSERT_TRUE(comes());
  std::vector<unsigned char> garbage(1000);
  for (std::size_t i = 0; i < garbage.size(); ++i) garbage[i] = static_cast<unsigned char>(i * 37 + 129);
  daemon.sendBytes(garbage);
  ASSERT_TRUE(eventually([&] {
    if (daemon.hasClient()) daemon.sendMotion(0, 350, 0);
    return now().axes[1] == 1.0;
  }));
}

TEST_F(Spacenav, PacketsThatComeInPiecesArePutTogether) {
  FakeSpacenavDaemon daemon(socket);
  SpacenavReader reader(hand);
  ASSERT_TRUE(comes());
  std::vector<unsigned char> packet(32);
  packet[4] = 175;
  for (int byte = 0; byte < 32; byte += 8) {
    daemon.sendBytes({packet.begin() + byte, packet.begin() + byte + 8});
    std::this_thread::sleep_for(milliseconds(15));
  }
  EXPECT_TRUE(eventually([&] { return now().axes[0] == 0.5; }));
  EXPECT_EQ(now().name, "SpaceNavigator");
}

TEST_F(Spacenav, HalfAPacketAndNoMoreEndsTheConnection) {
  FakeSpacenavDaemon daemon(socket);
  SpacenavReader reader(hand);
  ASSERT_TRUE(comes());
  daemon.sendBytes(std::vector<unsigned char>(13));
  EXPECT_TRUE(goes());
  EXPECT_TRUE(comes());
}

TEST_F(Spacenav, AFloodWakesTheReaderSeldomAndTheLastCounts) {
  FakeSpacenavDaemon daemon(socket);
  SpacenavReader reader(hand);
  ASSERT_TRUE(comes());
  const auto wakeUpsBefore = reader.wakeUps();
  const auto begun = Clock::now();
  constexpr int kPackets = 50000;
  for (int i = 0; i < kPackets; ++i) daemon.sendMotion(10 + i % 300, 0, 0);
  daemon.sendMotion(0, 350, 0);
  EXPECT_TRUE(eventually([&] { return now().axes[1] == 1.0; }));
  const auto elapsed = std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
  EXPECT_LE(static_cast<double>(reader.wakeUps() - wakeUpsBefore), elapsed / 2.0 + 10.0);
}

TEST_F(Spacenav, DeathsLeakNothingAndCostNothing) {
  SpacenavReader reader(hand, milliseconds(2));
  std::ptrdiff_t files = 0;
  std::ptrdiff_t bytes = 0;
  const int rounds = stressRounds(50);
  for (int round = -5; round < rounds; ++round) {
    if (round == 0) {
      files = openFiles();
      bytes = allocatedBytes();
    }
    auto daemon = std::make_unique<FakeSpacenavDaemon>(socket);
    ASSERT_TRUE(comes()) << round;
    daemon->sendMotion(350, 0, 0);
    daemon.reset();
    ASSERT_TRUE(goes()) << round;
    ASSERT_TRUE(now().atRest());
  }
  EXPECT_LE(openFiles(), files);
  EXPECT_LE(allocatedBytes() - bytes, 4096 + rounds);
  std::cout << rounds << " deaths: " << openFiles() - files << " files, " << allocatedBytes() - bytes << " bytes\n";
}

TEST_F(Spacenav, UnplugsLeakNothing) {
  FakeSpacenavDaemon daemon(socket);
  SpacenavReader reader(hand);
  ASSERT_TRUE(comes());
  const std::ptrdiff_t files = openFiles();
  const std::ptrdiff_t bytes = allocatedBytes();
  const int rounds = stressRounds(50);
  for (int round = 0; round < rounds; ++round) {
    daemon.plug(std::nullopt);
    ASSERT_TRUE(goes()) << round;
    daemon.plug("SpaceNavigator");
    ASSERT_TRUE(comes()) << round;
  }
  EXPECT_LE(openFiles(), files);
  EXPECT_LE(allocatedBytes() - bytes, 4096 + rounds);
  std::cout << rounds << " unplugs: " << openFiles() - files << " files, " << allocatedBytes() - bytes << " bytes\n";
}

TEST_F(Spacenav, ADeadOrIdleDaemonIsNotSpunOn) {
  auto daemon = std::make_unique<FakeSpacenavDaemon>(socket);
  SpacenavReader reader(hand);
  ASSERT_TRUE(comes());
  for (const bool dead : {false, true}) {
    if (dead) daemon.reset();
    rusage before{};
    getrusage(RUSAGE_SELF, &before);
    const auto wakeUpsBefore = reader.wakeUps();
    std::this_thread::sleep_for(milliseconds(1000));
    rusage after{};
    getrusage(RUSAGE_SELF, &after);
    EXPECT_LE(reader.wakeUps() - wakeUpsBefore, 60U) << "dead: " << dead;
    const auto micros = [](const rusage& usage) {
      return (usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) * 1000000L + usage.ru_utime.tv_usec +
             usage.ru_stime.tv_usec;
    };
    std::cout << (dead ? "dead" : "idle") << ": " << static_cast<double>(micros(after) - micros(before)) / 10000.0
              << " % CPU, with the fake daemon\n";
  }
}

TEST_F(Spacenav, AnExceptionIsToldAndTheMouseIsConnectedAgain) {
  std::atomic<int> calls{0};
  std::atomic<bool> notified{false};
  SpacenavReader reader(hand, milliseconds(20));
  hand->mouse6d.mailbox.setListener([&] {
    if (++calls == 1) throw std::bad_alloc();
    const auto problem = reader.problem();
    notified = notified || (problem && problem->kind == ErrorKind::LimitReached);
  });
  {
    FakeSpacenavDaemon daemon(socket);
    EXPECT_TRUE(eventually([&] { return notified.load(); }));
    EXPECT_TRUE(eventually([&] { return now().connected && !reader.problem(); }));
  }
  hand->mouse6d.mailbox.setListener({});
}

}  // namespace
}  // namespace glissade
