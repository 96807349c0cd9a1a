#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <stdexcept>

#include "tests/engine/support/session_support.h"

namespace glissade {
namespace {

TEST(ThreadedSession, EndsCleanlyInEveryState) {
  for (const int steps : {0, 1, 50}) {
    const auto session = makeThreadedSession(sessionConfig(closedProblem()));
    session->post(command::Start{});
    waitFor(*session, [&](const auto& s) { return s.counts.steps >= static_cast<std::uint64_t>(steps); });
  }
  const auto idle = makeThreadedSession(sessionConfig(closedProblem()));
  const auto paused = makeThreadedSession(sessionConfig(closedProblem()));
  paused->post(command::Start{});
  paused->post(command::Pause{});
  EXPECT_TRUE(waitFor(*paused, [](const auto& s) { return s.state == SessionState::Paused; }));
}

TEST(ThreadedSession, AtMostOneWakeUpIsPending) {
  const auto session = makeThreadedSession(sessionConfig(closedProblem()));
  std::atomic<int> calls{0};
  session->setWakeUp([&] { ++calls; });
  session->post(command::Start{});
  while (calls == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  // Nobody reads the snapshot, so that no further notification comes, however long the planner works.
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_EQ(calls, 1);
  session->snapshot();
  while (calls == 1) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  session->setWakeUp({});
}

TEST(ThreadedSession, KeepsThePaceAndAnswersAtOnceBetweenSteps) {
  const auto session = makeThreadedSession(sessionConfig(closedProblem()));
  session->post(command::SetParameter{ParameterId::Pace, 40.0});
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.counts.steps >= 4; }));
  const auto begin = std::chrono::steady_clock::now();
  const std::uint64_t before = session->snapshot()->counts.steps;
  ASSERT_TRUE(waitFor(*session, [&](const auto& s) { return s.counts.steps >= before + 8; }));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_GT(took.count(), 7 / 40.0) << "a loaded machine may be slower, never faster";
  // The next step is due after a second; a command does not wait for it.
  session->post(command::SetParameter{ParameterId::Pace, 1.0});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.parameters[ParameterId::Pace] == 1.0; }));
  session->post(command::SetParameter{ParameterId::Pace, 0.0});
  const std::uint64_t slow = session->snapshot()->counts.steps;
  EXPECT_TRUE(waitFor(*session, [&](const auto& s) { return s.counts.steps > slow + 500; })) << "full speed again";
}

/// Moves all the time, like a simulated operator that keeps correcting.
class RestlessOperator final : public OperatorDevice {
 public:
  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override {
    return integrate(view.q_device, {Vector3(0.1 * std::sin(time_ += dt), 0, 0), Vector3::Zero()}, bounds, dt);
  }
  bool isSimulated() const override { return true; }

 private:
  double time_ = 0.0;
};

TEST(ThreadedSession, ASimulatedOperatorRestsOnceTheRunHasEnded) {
  const auto session = makeThreadedSession(sessionConfig(windowProblem(), std::make_unique<RestlessOperator>()));
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.device.moves > 3; })) << "it acts before a run";
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.state == SessionState::Solved; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // a tick may be under way
  const std::uint64_t moves = session->snapshot()->device.moves;
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_EQ(session->snapshot()->device.moves, moves);
  session->post(command::Start{});
  EXPECT_TRUE(waitFor(*session, [&](const auto& s) { return s.device.moves > moves; })) << "back to the start";
}

/// Moves aside until a run begins, and rests then.
class DeviceAside final : public OperatorDevice {
 public:
  Pose advance(double dt, const OperatorView& view, const Box3& bounds) override {
    return began_ ? view.q_device : integrate(view.q_device, {Vector3(0.1, 0.0, 0.0), Vector3::Zero()}, bounds, dt);
  }
  void restart() override { began_ = true; }

 private:
  bool began_ = false;
};

TEST(ThreadedSession, TheFirstStepOfARunSeesTheHandAtTheStart) {
  for (int i = 0; i < 10; ++i) {
    const Problem problem = closedProblem();
    const auto session = makeThreadedSession(sessionConfig(problem, std::make_unique<DeviceAside>()));
    ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.device.moves > 0; }));
    session->post(command::Start{});
    ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.counts.steps > 0; }));
    session->post(command::Stop{});
    ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.state == SessionState::Stopped; }));
    const RunLog log = joined(session->snapshot()->log);
    ASSERT_FALSE(log.operatorStream.empty());
    EXPECT_EQ(log.operatorStream.front().q_device, problem.start);
  }
}

TEST(ThreadedSession, TheObjectRestsWhileTheRunIsPaused) {
  const auto session = makeThreadedSession(sessionConfig(closedProblem(), std::make_unique<RestlessOperator>()));
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.device.moves > 3; }));
  session->post(command::Pause{});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.state == SessionState::Paused; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // the tick that was under way
  const std::uint64_t moves = session->snapshot()->device.moves;
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_EQ(session->snapshot()->device.moves, moves);
  session->post(command::Resume{});
  EXPECT_TRUE(waitFor(*session, [&](const auto& s) { return s.device.moves > moves; }));
}

/// Rests until it is told to move.
class PatientDevice final : public OperatorDevice {
 public:
  explicit PatientDevice(std::shared_ptr<std::atomic<bool>> moves) : moves_(std::move(moves)) {}
  Pose advance(double, const OperatorView& view, const Box3&) override {
    Pose q = view.q_device;
    if (*moves_) q.position.x() -= 0.01;
    return q;
  }

 private:
  std::shared_ptr<std::atomic<bool>> moves_;
};

TEST(ThreadedSession, ARunWithAHandBeginsWithItsFirstMotion) {
  const auto moves = std::make_shared<std::atomic<bool>>(false);
  const auto session = makeThreadedSession(sessionConfig(closedProblem(), std::make_unique<PatientDevice>(moves)));
  session->post(command::SetParameter{ParameterId::Alpha, 0.5});
  session->post(command::Start{true});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.waitsForHand; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const SnapshotPtr waiting = session->snapshot();
  EXPECT_EQ(waiting->state, SessionState::Planning);
  EXPECT_EQ(waiting->counts.steps, 0U);
  EXPECT_EQ(waiting->virtualSeconds, 0.0) << "the time of the person begins with their motion";
  *moves = true;
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.counts.steps > 0; }));
  EXPECT_FALSE(session->snapshot()->waitsForHand);
}

TEST(ThreadedSession, NobodyWaitsForAHandThatTheComputerDoesNotNeed) {
  const auto still = std::make_shared<std::atomic<bool>>(false);
  const auto session = makeThreadedSession(sessionConfig(closedProblem(), std::make_unique<PatientDevice>(still)));
  session->post(command::SetParameter{ParameterId::Alpha, 0.5});
  session->post(command::Start{true});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.waitsForHand; }));
  session->post(command::SetParameter{ParameterId::Alpha, 1.0});
  EXPECT_TRUE(waitFor(*session, [](const auto& s) { return s.counts.steps > 0; })) << "the computer finishes the run";
  const auto alone = makeThreadedSession(sessionConfig(closedProblem()));
  alone->post(command::Start{true});
  EXPECT_TRUE(waitFor(*alone, [](const auto& s) { return s.counts.steps > 0; })) << "nobody holds the object";
}

class FailingDevice final : public OperatorDevice {
 public:
  Pose advance(double, const OperatorView&, const Box3&) override { throw std::runtime_error("cable out"); }
};

TEST(ThreadedSession, AFailingDeviceIsReportedAndPlanningGoesOn) {
  const auto session = makeThreadedSession(sessionConfig(windowProblem(), std::make_unique<FailingDevice>()));
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.problem.has_value(); }));
  EXPECT_NE(toString(session->snapshot()->problem->reason).find("cable out"), std::string::npos);
  session->post(command::Start{});
  EXPECT_TRUE(waitFor(*session, [](const auto& s) { return s.state == SessionState::Solved; }));
}

/// The thread sanitizer checks that the view, which the window sets, and the hand, which reads it, exclude each other.
TEST(ThreadedSession, ViewsReadersAndListenersChangeWhileTheHandMoves) {
  const auto session =
      makeThreadedSession(sessionConfig(closedProblem(), std::make_unique<HomingDevice>(Vector3(-0.3, 0, 0))));
  std::atomic<bool> done{false};
  std::thread view([&] {
    for (double angle = 0.0; !done; angle += 0.01) {
      session->setOperatorFrame({fromRollPitchYaw(0.0, 0.0, angle), {}});
      session->setWakeUp([] {});
    }
  });
  session->post(command::Start{});
  EXPECT_TRUE(waitFor(*session, [](const auto& s) { return s.device.moves > 20; }));
  done = true;
  view.join();
}

TEST(ThreadedSession, ManyStartsStopsAndReadersDoNotDisturbEachOther) {
  const auto session =
      makeThreadedSession(sessionConfig(closedProblem(), std::make_unique<HomingDevice>(Vector3(-0.3, 0, 0))));
  std::atomic<bool> done{false};
  std::thread reader([&] {
    while (!done) {
      const SnapshotPtr snapshot = session->snapshot();
      EXPECT_LE(snapshot->counts.edges, 2 * snapshot->counts.nodes);
    }
  });
  for (int i = 0; i < 20; ++i) {
    session->post(command::Start{});
    session->post(command::SetParameter{ParameterId::Alpha, 0.05 * i});
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    session->post(command::Stop{});
  }
  EXPECT_TRUE(waitFor(*session, [](const auto& s) { return s.run == 20 && s.state == SessionState::Stopped; }));
  done = true;
  reader.join();
}

}  // namespace
}  // namespace glissade
