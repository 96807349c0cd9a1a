#include "widgets/devices/head_receiver.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>

#include <cstdlib>
#include <cstring>
#include <random>
#include <vector>

#include "tests/widgets/devices/fake_head_tracker.h"

namespace glissade {
namespace {

class HeadReceiverTest : public testing::Test {
 protected:
  HeadReceiverTest() {
    QObject::connect(&receiver_, &HeadReceiver::received, [this](const HeadReading& reading) {
      ++received_;
      last_ = reading;
    });
  }

  /// Waits until it has happened, for at most 5 seconds.
  template <class Happened>
  bool wait(Happened happened) {
    QElapsedTimer since;
    since.start();
    while (!happened() && since.elapsed() < 5000) QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    return happened();
  }

  HeadReceiver receiver_;
  int received_ = 0;
  HeadReading last_{};
};

TEST_F(HeadReceiverTest, GivesWhatATrackerSends) {
  ASSERT_TRUE(receiver_.open(0, false));
  test::FakeHeadTracker tracker(receiver_.port());
  tracker.send({12.0, -3.0, 60.0, 10.0, 0.0, -5.0});
  ASSERT_TRUE(wait([this] { return received_ > 0; }));
  EXPECT_DOUBLE_EQ(last_[0], 0.12);
  EXPECT_DOUBLE_EQ(last_[2], 0.6);
}

TEST_F(HeadReceiverTest, ListensToThisMachineOnlyUnlessAPersonSaysOtherwise) {
  ASSERT_TRUE(receiver_.open(0, false));
  EXPECT_EQ(receiver_.address(), QHostAddress(QHostAddress::LocalHost));
  ASSERT_TRUE(receiver_.open(0, true));
  EXPECT_EQ(receiver_.address(), QHostAddress(QHostAddress::AnyIPv4));
  receiver_.close();
  EXPECT_EQ(receiver_.port(), 0);
}

TEST_F(HeadReceiverTest, APortThatIsTakenIsATrouble) {
  HeadReceiver other;
  ASSERT_TRUE(other.open(0, false));
  EXPECT_FALSE(receiver_.open(other.port(), false));
  EXPECT_FALSE(receiver_.trouble().isEmpty());
  EXPECT_FALSE(receiver_.isOpen());
}

/// GLISSADE_HEAD_DATAGRAMS sets another number of datagrams. The kernel may drop some of many.
TEST_F(HeadReceiverTest, HostileDatagramsAreDroppedAndTheNextHeadIsSeen) {
  ASSERT_TRUE(receiver_.open(0, false));
  test::FakeHeadTracker tracker(receiver_.port());
  const char* asked = std::getenv("GLISSADE_HEAD_DATAGRAMS");
  const long count = asked != nullptr ? std::atol(asked) : 100'000;
  std::mt19937_64 random(4242);
  std::vector<char> bytes;
  for (long i = 0; i < count; ++i) {
    bytes.resize(i % 2 == 0 ? kOpentrackBytes : random() % 1400);
    for (char& byte : bytes) byte = static_cast<char>(random());
    // No datagram of the right size is a head: its first number is a NaN.
    if (bytes.size() == kOpentrackBytes) std::memset(bytes.data(), 0xff, 8);
    tracker.sendBytes(bytes);
    if (i % 100 == 0) QCoreApplication::processEvents();
  }
  EXPECT_TRUE(wait([this] { return receiver_.dropped() > 0; }));
  EXPECT_EQ(received_, 0);
  const auto isSeen = [this, &tracker] {
    tracker.send({1.0, 2.0, 3.0, 0.0, 0.0, 0.0});
    return received_ > 0;
  };
  EXPECT_TRUE(wait(isSeen));
  EXPECT_DOUBLE_EQ(last_[1], 0.02);
}

}  // namespace
}  // namespace glissade
