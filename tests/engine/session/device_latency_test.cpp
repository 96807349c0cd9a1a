// Measures the time from a packet of the 6D mouse's daemon to the snapshot with the moved object, while planning.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/base/random_stream.h"
#include "engine/operator/shaped_device.h"
#include "engine/operator/sliding_hand.h"
#include "engine/operator/spacenav_reader.h"
#include "engine/session/session.h"
#include "tests/engine/operator/fake_spacenav_daemon.h"
#include "tests/engine/operator/process_load.h"
#include "tests/engine/support/session_support.h"

namespace glissade {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// A window that only reads snapshots when it is notified.
class Window {
 public:
  explicit Window(Session& session) : session_(session) {
    session.setWakeUp([this] {
      const std::lock_guard lock(mutex_);
      woken_ = true;
      wake_.notify_all();
    });
  }
  ~Window() { session_.setWakeUp({}); }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  SnapshotPtr next() {
    std::unique_lock lock(mutex_);
    wake_.wait_for(lock, milliseconds(100), [this] { return woken_; });
    woken_ = false;
    lock.unlock();
    return session_.snapshot();
  }

 private:
  Session& session_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool woken_ = false;
};

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

TEST(DeviceLatency, AMoveOfTheMouseReachesTheSnapshotWhilePlanning) {
  const std::string socket = testing::TempDir() + "glissade-latency-" + std::to_string(::getpid()) + ".sock";
  setenv("SPNAV_SOCKET", socket.c_str(), 1);
  FakeSpacenavDaemon daemon(socket);
  const HandInputsPtr hand = std::make_shared<HandInputs>();
  const SpacenavReader reader(hand, milliseconds(5));
  while (!hand->mouse6d.mailbox.reading().connected) std::this_thread::sleep_for(milliseconds(5));

  const Problem problem = closedProblem();
  auto device = std::make_unique<SlidingHand>(problem.world, std::make_unique<ShapedDevice>(hand, hand->mouse6d));
  SessionConfig config = sessionConfig(problem, std::move(device));
  config.plannerId = "interactive";
  const auto session = makeThreadedSession(std::move(config));
  Window window(*session);
  session->post(command::Start{});
  while (window.next()->state != SessionState::Planning) {
  }

  RandomStream phases(1, "phases");
  std::vector<double> latencies;
  const int rounds = stressRounds(20);
  for (int round = 0; round < rounds; ++round) {
    daemon.sendMotion(0, 0, 0);
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(60.0 + phases.uniform(0.0, 16.0)));
    const auto before = session->snapshot()->device.moves;
    const auto sent = Clock::now();
    daemon.sendMotion(round % 2 == 0 ? 200 : -200, 0, 0);
    while (window.next()->device.moves == before) {
      ASSERT_LT(Clock::now() - sent, milliseconds(5000));
    }
    latencies.push_back(std::chrono::duration<double, std::milli>(Clock::now() - sent).count());
  }
  EXPECT_EQ(session->snapshot()->state, SessionState::Planning);
  std::cout << rounds << " moves: median " << quantile(latencies, 0.5) << " ms, p99 " << quantile(latencies, 0.99)
            << " ms, longest " << quantile(latencies, 1.0) << " ms\n";
  unsetenv("SPNAV_SOCKET");
}

}  // namespace
}  // namespace glissade
