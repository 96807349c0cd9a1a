// Tests the loop in real time beside a planner. Its delays depend on the machine, so that they are reported and not
// judged: GLISSADE_HAPTIC_SECONDS=60 haptic_test --gtest_filter='HapticLoop*'
#include "engine/operator/haptic/haptic_loop.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <new>
#include <stdexcept>
#include <thread>

#include "engine/files/scenario_io.h"
#include "engine/operator/haptic/haptic_operator.h"
#include "engine/operator/haptic/simulated_haptic_device.h"
#include "tests/engine/operator/haptic/haptic_support.h"
#include "tests/engine/support/directories.h"
#include "tests/engine/support/random_pose.h"
#include "tests/engine/support/session_support.h"

namespace glissade {
namespace {

double secondsToHold() {
  const char* wanted = std::getenv("GLISSADE_HAPTIC_SECONDS");
  return wanted != nullptr ? std::atof(wanted) : 1.0;
}

OperatorView viewFrom(const Pose& q) {
  OperatorView view;
  view.q_device = q;
  return view;
}

/// Runs the loop while a planner works on another thread; the hand moves at random and touches obstacles often.
HapticReport hold(const Problem& problem, const std::string& what) {
  const auto session = makeThreadedSession(sessionConfig(problem));
  const double radius = problem.world->objectRadius();
  std::vector<Pose> aims;
  RandomStream stream(1, "hand");
  for (int i = 0; i < 100; ++i) {
    Pose aim = randomPose(stream, 1.0);
    aim.position = problem.bounds.center() + 0.5 * aim.position.cwiseProduct(problem.bounds.sizes());
    aims.push_back(aim);
  }
  auto device = std::make_unique<SimulatedHapticDevice>(alongRoute(aims, problem.metric(), radius), radius);
  HapticOrders orders;
  orders.guidance = {0.5, 0.3, 0.1 * radius, std::nullopt};
  orders.bounds = problem.bounds;
  orders.q = problem.start;
  HapticLoop loop(problem.world, std::move(device), orders);
  const auto judge = problem.world->makeQuery();
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(secondsToHold());
  while (std::chrono::steady_clock::now() < end) {
    if (!isRunning(*session->snapshot())) session->post(command::Start{});
    EXPECT_FALSE(judge->collides(loop.report().cycle.q));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  const HapticReport report = loop.report();
  std::string load;
  std::getline(std::ifstream("/proc/loadavg"), load);
  std::cout << what << ": " << report.cycles << " cycles, " << report.late << " late by more than 0.2 ms ("
            << 100.0 * static_cast<double>(report.late) / static_cast<double>(std::max<std::uint64_t>(1, report.cycles))
            << " %), longest delay " << 1e3 * report.longestDelay << " ms, " << report.queries << " looks about, load "
            << load << "\n";
  return report;
}

TEST(HapticLoop, RunsBesideThePlannerOnEnvironment1) {
  const auto loaded = loadScenario(test::sourceDirectory() + "/samples/environment-1/scenario.json");
  ASSERT_TRUE(loaded);
  const HapticReport report = hold(loaded->problem, "environment 1");
  EXPECT_GT(report.cycles, 100U);
  EXPECT_GT(report.queries, 10U);
}

TEST(HapticLoop, RunsBesideThePlannerOnTwoPartsOf100000Triangles) {
  Problem problem = windowProblem();
  problem.world = denseWorld();
  problem.start = Pose::translation({1.6, 0.0, 0.0});
  problem.goal = Pose::translation({-1.6, 0.0, 0.0});
  const HapticReport report = hold(problem, "100,000 triangles");
  EXPECT_GT(report.cycles, 100U);
  EXPECT_GT(report.queries, 10U);
}

TEST(HapticLoop, PutsTheObjectWhereItIsToldAndStopsAtOnce) {
  const Problem problem = windowProblem();
  const double radius = problem.world->objectRadius();
  HapticOperator person(
      problem.world, std::make_unique<SimulatedHapticDevice>([](double, const Pose& begin) { return begin; }, radius));
  for (int i = 0; i < 20; ++i) {
    const Pose put = Pose::translation({-1.5, 0.05 * i, 0.0});
    EXPECT_EQ(person.advance(0.008, viewFrom(put), problem.bounds), put);
    Pose q = put;
    for (int j = 0; j < 5; ++j) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      q = person.advance(0.008, viewFrom(q), problem.bounds);
    }
    EXPECT_LT((q.position - put.position).norm(), 1e-9);
  }
  EXPECT_TRUE(person.connected());
}

/// In both kinds of sessions the object follows the hand and stays free.
TEST(HapticSession, TheObjectFollowsTheHandAndStaysFree) {
  for (const bool realTime : {false, true}) {
    const Problem problem = closedProblem();
    DeviceContext context;
    context.route = {Pose::translation({1.5, 0.5, 0.5})};
    context.metric = problem.metric();
    context.world = problem.world;
    context.realTime = realTime;
    auto device = makeDeviceRegistry().find("simulated-haptic")->make(context);
    ASSERT_NE(device, nullptr);
    SessionConfig config = sessionConfig(problem, std::move(device));
    std::unique_ptr<Session> session = realTime ? makeThreadedSession(std::move(config))
                                                : std::unique_ptr<Session>(makeLockstepSession(std::move(config)));
    session->post(command::Start{});
    EXPECT_TRUE(waitFor(*session, [](const SessionSnapshot& now) {
      return now.device.q_device.position.x() > -0.32 && now.device.guidance.force_W.x() < -0.3;
    }));
    EXPECT_GT(session->snapshot()->device.nearest.distance, 0.0);
    EXPECT_LT(session->snapshot()->device.q_device.position.x(), 0.0);
  }
}

/// Throws after some cycles of the loop, and again when its wrench is to be set to zero.
class BreakingDevice final : public HapticDevice {
 public:
  explicit BreakingDevice(void (*raise)()) : raise_(raise) {}

  HapticState advance(double) override {
    if (++cycles_ > 20) raise_();
    return {place_, {}, 0};
  }
  void render(const Wrench&) override {
    if (cycles_ > 20) raise_();
  }
  HapticLimits limits() const override { return {10.0, 1.0}; }
  void place(const Pose& X_WD) override { place_ = X_WD; }

 private:
  void (*raise_)();
  int cycles_ = 0;
  Pose place_;
};

TEST(HapticSession, AnExceptionInTheLoopTakesTheDeviceAwayAndPlanningGoesOn) {
  const std::pair<void (*)(), ErrorKind> thrown[] = {{[] { throw std::bad_alloc(); }, ErrorKind::LimitReached},
                                                     {[] { throw std::runtime_error("no arm"); }, ErrorKind::Internal}};
  for (const auto& [raise, kind] : thrown) {
    const Problem problem = windowProblem();
    const auto session = makeThreadedSession(sessionConfig(
        problem, std::make_unique<HapticOperator>(problem.world, std::make_unique<BreakingDevice>(raise))));
    ASSERT_TRUE(waitFor(*session, [](const SessionSnapshot& now) { return now.problem.has_value(); }));
    EXPECT_EQ(session->snapshot()->problem->kind, kind);
    EXPECT_EQ(toString(session->snapshot()->problem->location), "device");
    session->post(command::Start{});
    EXPECT_TRUE(waitFor(*session, [](const SessionSnapshot& now) { return now.state == SessionState::Solved; }));
  }
}

}  // namespace
}  // namespace glissade
