// Tests allocations that fail at arbitrary places: the session reports it and goes on.
#include <gtest/gtest.h>

#include <limits>

#include "engine/base/random_stream.h"
#include "tests/engine/support/failing_allocation.h"
#include "tests/engine/support/session_support.h"

namespace glissade {
namespace {

using test::FailingAllocation;
using Where = FailingAllocation::Where;

constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();
/// Number of consecutive allocations that fail: a single one, or many, as when memory is used up.
constexpr std::uint64_t kStretches[] = {1, 30};

SessionConfig smoothingConfig(const std::string& planner) {
  SessionConfig config = sessionConfig(windowProblem());
  config.plannerId = planner;
  EXPECT_TRUE(config.parameters.set(ParameterId::Smoothing, 50));
  return config;
}

/// Runs the session to its end after a Start.
void runToEnd(LockstepSession& session) {
  session.advance(20);
  for (int i = 0; i < 100'000 && !hasEnded(*session.snapshot()); ++i) session.advance(20);
}

/// Starts a run in which allocations fail; returns the number of allocations.
std::uint64_t startWithFailure(LockstepSession& session, std::uint64_t first, std::uint64_t count) {
  session.post(command::Start{});
  const FailingAllocation failing(Where::ThisThread, first, count);
  runToEnd(session);
  return failing.calls();
}

class AllocationFailure : public testing::TestWithParam<const char*> {};

TEST_P(AllocationFailure, InARunEndsThatRunOnly) {
  const auto undisturbed = makeLockstepSession(smoothingConfig(GetParam()));
  const std::uint64_t calls = startWithFailure(*undisturbed, kNever, 1);
  ASSERT_EQ(undisturbed->snapshot()->state, SessionState::Solved);
  const std::size_t configurations = undisturbed->snapshot()->path->points.size();
  RandomStream stream(1, "allocation failures");
  int failed = 0;
  for (int i = 0; i < 40; ++i) {
    // A new session is needed, because the destructors of OMPL's planners, which Start calls, allocate memory.
    const auto session = makeLockstepSession(smoothingConfig(GetParam()));
    // Half of the failures are among the first allocations, which make the planners.
    const double share = i % 2 == 0 ? stream.uniform() : stream.uniform() * 0.02;
    const auto first = 1 + static_cast<std::uint64_t>(share * static_cast<double>(calls));
    startWithFailure(*session, first, kStretches[i % 4 / 2]);
    const SnapshotPtr snapshot = session->snapshot();
    ASSERT_TRUE(hasEnded(*snapshot)) << first;
    if (snapshot->problem) {
      ++failed;
      EXPECT_EQ(snapshot->problem->kind, ErrorKind::LimitReached) << toString(snapshot->problem->reason);
    }
    startWithFailure(*session, kNever, 1);
    EXPECT_EQ(session->snapshot()->state, SessionState::Solved);
    EXPECT_FALSE(session->snapshot()->problem);
    EXPECT_EQ(session->snapshot()->path->points.size(), configurations);
  }
  EXPECT_GT(failed, 10);
}

/// The run ends visibly, even though the snapshot cannot be made any more.
TEST_P(AllocationFailure, ForGoodEndsTheRun) {
  const auto undisturbed = makeLockstepSession(smoothingConfig(GetParam()));
  const std::uint64_t calls = startWithFailure(*undisturbed, kNever, 1);
  const auto session = makeLockstepSession(smoothingConfig(GetParam()));
  // Other threads share the work of a round, so that the number of calls on this one varies.
  startWithFailure(*session, calls / 8, kNever);
  const SnapshotPtr snapshot = session->snapshot();
  ASSERT_TRUE(hasEnded(*snapshot));
  ASSERT_TRUE(snapshot->problem);
  EXPECT_EQ(snapshot->problem->kind, ErrorKind::LimitReached);
}

INSTANTIATE_TEST_SUITE_P(Planners, AllocationFailure, testing::Values("contact-birrt", "auto", "ompl-rrtconnect"),
                         [](const testing::TestParamInfo<const char*>& parameter) {
                           std::string name = parameter.param;
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

TEST(AllocationFailureOfPathWork, LeavesThePathAsItWas) {
  const auto session = makeLockstepSession(sessionConfig(windowProblem()));
  session->post(command::Start{});
  runToEnd(*session);
  const auto planned = session->snapshot()->path;
  ASSERT_NE(planned, nullptr);
  int failed = 0;
  for (std::uint64_t first = 1; first < 2000; first = 1 + 3 * first / 2) {
    session->post(command::SmoothPath{50});
    {
      const FailingAllocation failing(Where::ThisThread, first);
      session->advance(0);
    }
    const SnapshotPtr snapshot = session->snapshot();
    ASSERT_EQ(snapshot->state, SessionState::Solved);
    ASSERT_NE(snapshot->path, nullptr);
    EXPECT_EQ(snapshot->path->certificate.status, CertificateStatus::Certified);
    if (!snapshot->problem) continue;
    ++failed;
    EXPECT_EQ(snapshot->problem->kind, ErrorKind::LimitReached);
    EXPECT_EQ(snapshot->smoothed, false);
    session->post(command::SmoothPath{0});
    session->advance(0);
    EXPECT_FALSE(session->snapshot()->problem);
    EXPECT_EQ(session->snapshot()->path->points.size(), planned->points.size());
  }
  EXPECT_GT(failed, 3);
}

TEST(AllocationFailureOfPathWork, LeavesAPathThatCouldNotBeExaminedOut) {
  const Problem problem = windowProblem();
  const auto first = makeLockstepSession(sessionConfig(problem));
  first->post(command::Start{});
  runToEnd(*first);
  const auto planned = first->snapshot()->path;
  ASSERT_NE(planned, nullptr);
  int failed = 0;
  for (std::uint64_t number = 1; number < 200; number += 3) {
    const auto session = makeLockstepSession(sessionConfig(problem));
    session->post(command::ExaminePath{planned->points, {}});
    {
      const FailingAllocation failing(Where::ThisThread, number);
      session->advance(0);
    }
    if (!session->snapshot()->problem) continue;
    ++failed;
    EXPECT_EQ(session->snapshot()->problem->kind, ErrorKind::LimitReached);
    session->post(command::ExaminePath{planned->points, {}});
    session->advance(0);
    ASSERT_EQ(session->snapshot()->state, SessionState::Solved);
  }
  EXPECT_GT(failed, 0);
}

/// Allocations fail on the session's threads: operator, planner and the portfolio's helpers.
TEST(AllocationFailureOfThreads, LeavesTheSessionAtWork) {
  RandomStream stream(1, "allocation failures");
  for (int i = 0; i < 16; ++i) {
    SessionConfig config = smoothingConfig(i % 2 == 0 ? "contact-birrt" : "auto");
    ASSERT_TRUE(config.parameters.set(ParameterId::Slots, 2));
    config.device = std::make_unique<HomingDevice>(Vector3(-0.32, 0, 0));
    const auto session = makeThreadedSession(std::move(config));
    session->setWakeUp([] {});
    {
      const FailingAllocation failing(Where::OtherThreads, 1 + static_cast<std::uint64_t>(stream.uniform() * 3000.0),
                                      kStretches[i % 4 / 2]);
      session->post(command::Start{});
      waitFor(*session, hasEnded, std::chrono::seconds(1));
    }
    session->post(command::Stop{});
    session->post(command::Start{});
    ASSERT_TRUE(waitFor(*session, [](const SessionSnapshot& s) { return s.run == 2 && hasEnded(s); })) << i;
    EXPECT_EQ(session->snapshot()->state, SessionState::Solved) << i;
  }
}

}  // namespace
}  // namespace glissade
