// The threaded session and the lockstep session keep the same contract.
#include <gtest/gtest.h>

#include <atomic>

#include "tests/engine/support/session_support.h"

namespace glissade {
namespace {

using Maker = std::unique_ptr<Session> (*)(SessionConfig);

std::unique_ptr<Session> makeLockstep(SessionConfig config) { return makeLockstepSession(std::move(config)); }

class SessionConformance : public testing::TestWithParam<std::pair<const char*, Maker>> {
 protected:
  std::unique_ptr<Session> make(SessionConfig config) const { return GetParam().second(std::move(config)); }
};

TEST_P(SessionConformance, IsIdleUntilStarted) {
  const auto session = make(sessionConfig(windowProblem()));
  const SnapshotPtr snapshot = session->snapshot();
  ASSERT_NE(snapshot, nullptr);
  EXPECT_EQ(snapshot->state, SessionState::Idle);
  EXPECT_TRUE(snapshot->roadmap.empty());
  EXPECT_EQ(snapshot->device.q_device, windowProblem().start);
}

TEST_P(SessionConformance, AParameterSetByHandIsTakenBackFromTheTuner) {
  const auto session = make(sessionConfig(closedProblem(), std::make_unique<HomingDevice>(Vector3(-0.35, 0.5, 0.2))));
  session->post(command::SetParameter{ParameterId::Tuning, kTunedAll});
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, [](const SessionSnapshot& now) { return now.tuning && now.counts.steps > 100; }));
  const double own = session->snapshot()->parameters[ParameterId::ContactSamples];
  EXPECT_EQ(own, ParameterValues(1.0)[ParameterId::ContactSamples]);  // the tuner does not change the user's values
  session->post(command::SetParameter{ParameterId::Alpha, 0.35});
  ASSERT_TRUE(waitFor(*session, [](const SessionSnapshot& now) { return now.parameters[ParameterId::Alpha] == 0.35; }));
  SnapshotPtr snapshot = session->snapshot();
  EXPECT_EQ(snapshot->parameters.integer(ParameterId::Tuning), kTunedContactSamples | kTunedContactDistance);
  EXPECT_EQ(valueInForce(*snapshot, ParameterId::Alpha), 0.35);
  session->post(command::SetParameter{ParameterId::Tuning, 0.0});
  ASSERT_TRUE(waitFor(*session, [](const SessionSnapshot& now) { return now.parameters[ParameterId::Tuning] == 0.0; }));
  snapshot = session->snapshot();
  EXPECT_EQ(valueInForce(*snapshot, ParameterId::ContactSamples), own);
}

TEST_P(SessionConformance, SolvesAndDeliversRoadmapPathAndLog) {
  const auto session = make(sessionConfig(windowProblem()));
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, hasEnded));
  const SnapshotPtr snapshot = session->snapshot();
  ASSERT_EQ(snapshot->state, SessionState::Solved);
  EXPECT_FALSE(snapshot->problem);
  ASSERT_NE(snapshot->path, nullptr);
  EXPECT_EQ(snapshot->path->certificate.status, CertificateStatus::Certified);
  EXPECT_EQ(allNodes(snapshot->roadmap).size(), snapshot->counts.nodes);
  EXPECT_FALSE(snapshot->log.empty());
  EXPECT_GT(snapshot->planningSeconds, 0.0);
}

TEST_P(SessionConformance, RevisionsGrowAndPublishedChunksAreSharedNotCopied) {
  const auto session = make(sessionConfig(closedProblem()));
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.counts.nodes > 20; }));
  const SnapshotPtr earlier = session->snapshot();
  ASSERT_TRUE(waitFor(*session, [&](const auto& s) { return s.counts.nodes > earlier->counts.nodes + 20; }));
  const SnapshotPtr later = session->snapshot();
  EXPECT_GT(later->revision, earlier->revision);
  ASSERT_GE(later->roadmap.size(), earlier->roadmap.size());
  for (std::size_t i = 0; i < earlier->roadmap.size(); ++i) EXPECT_EQ(later->roadmap[i], earlier->roadmap[i]);
}

TEST_P(SessionConformance, PauseHoldsTheRoadmapAndResumeGoesOn) {
  const auto session = make(sessionConfig(closedProblem()));
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.counts.steps > 5; }));
  session->post(command::Pause{});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.state == SessionState::Paused; }));
  const std::uint64_t steps = session->snapshot()->counts.steps;
  waitFor(
      *session, [](const auto&) { return false; }, std::chrono::seconds(0));
  EXPECT_EQ(session->snapshot()->counts.steps, steps);
  session->post(command::Resume{});
  EXPECT_TRUE(waitFor(*session, [&](const auto& s) { return s.counts.steps > steps + 5; }));
}

TEST_P(SessionConformance, StopKeepsWhatWasFoundAndARestartBeginsAnew) {
  const auto session = make(sessionConfig(closedProblem()));
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.counts.steps > 5; }));
  session->post(command::Stop{});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.state == SessionState::Stopped; }));
  const SnapshotPtr stopped = session->snapshot();
  EXPECT_GT(stopped->counts.nodes, 2U);
  EXPECT_FALSE(stopped->roadmap.empty());
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, [&](const auto& s) { return s.run == stopped->run + 1; }));
  EXPECT_NE(session->snapshot()->roadmap.empty() ? nullptr : session->snapshot()->roadmap[0], stopped->roadmap[0]);
}

TEST_P(SessionConformance, PlannersSideBySideAreShownAndStopped) {
  SessionConfig config = sessionConfig(closedProblem());
  config.plannerId = "auto";
  ASSERT_TRUE(config.parameters.set(ParameterId::Slots, 4));
  const auto session = make(std::move(config));
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.counts.steps > 2000 && !s.member.empty(); }));
  EXPECT_NE(session->snapshot()->member.find(", "), std::string::npos);
  session->post(command::Stop{});
  ASSERT_TRUE(waitFor(*session, hasEnded));
  const SnapshotPtr stopped = session->snapshot();
  EXPECT_EQ(stopped->state, SessionState::Stopped);
  EXPECT_EQ(allNodes(stopped->roadmap).size(), stopped->counts.nodes);
  EXPECT_GT(stopped->planningCpuSeconds, 0.0);
}

TEST_P(SessionConformance, ParametersChangeWhileItRunsAndAreLogged) {
  const auto session = make(sessionConfig(closedProblem()));
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.counts.steps > 3; }));
  session->post(command::SetParameter{ParameterId::Alpha, 0.75});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.parameters[ParameterId::Alpha] == 0.75; }));
  session->post(command::Stop{});
  ASSERT_TRUE(waitFor(*session, hasEnded));
  const SnapshotPtr snapshot = session->snapshot();
  const RunLog log = joined(snapshot->log);
  ASSERT_EQ(log.parameterChanges.size(), 1U);
  EXPECT_EQ(log.parameterChanges[0].value, 0.75);
  EXPECT_GT(log.parameterChanges[0].step, 3U);
}

TEST_P(SessionConformance, ABadParameterIsRefusedInWordsAndTheRunGoesOn) {
  const auto session = make(sessionConfig(closedProblem()));
  session->post(command::Start{});
  session->post(command::SetParameter{ParameterId::Alpha, 7.0});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.problem.has_value(); }));
  EXPECT_EQ(session->snapshot()->state, SessionState::Planning);
  EXPECT_EQ(toString(session->snapshot()->problem->location), "alpha");
}

TEST_P(SessionConformance, LimitsEndTheRunWithAReason) {
  SessionConfig config = sessionConfig(closedProblem());
  ASSERT_TRUE(config.parameters.set(ParameterId::MaxSteps, 30));
  const auto session = make(std::move(config));
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, hasEnded));
  const SnapshotPtr snapshot = session->snapshot();
  EXPECT_EQ(snapshot->state, SessionState::Failed);
  EXPECT_EQ(snapshot->problem->kind, ErrorKind::LimitReached);
  EXPECT_EQ(snapshot->counts.steps, 30U);
}

TEST_P(SessionConformance, AStartInCollisionIsRefusedNamingTheBody) {
  Problem problem = windowProblem();
  problem.start = Pose::translation({0.0, 1.5, 0.0});
  const auto session = make(sessionConfig(problem));
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, hasEnded));
  EXPECT_EQ(session->snapshot()->problem->kind, ErrorKind::InCollision);
  EXPECT_EQ(toString(session->snapshot()->problem->location), "start");
  EXPECT_NE(toString(session->snapshot()->problem->reason).find("right"), std::string::npos);
}

TEST_P(SessionConformance, AnUnknownPlannerIsRefusedAndTheOldOneStays) {
  const auto session = make(sessionConfig(windowProblem()));
  session->post(command::SetPlanner{"warp-drive"});
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.problem.has_value(); }));
  EXPECT_EQ(session->snapshot()->plannerId, "contact-birrt");
}

TEST_P(SessionConformance, TheOperatorMovesTheObjectAndIsPutBackAtAStart) {
  const auto session = make(sessionConfig(closedProblem(), std::make_unique<HomingDevice>(Vector3(-0.32, 0, 0))));
  ASSERT_TRUE(waitFor(*session, [](const auto& s) { return s.device.q_device.position.x() > -0.32 - 1e-8; }));
  EXPECT_NEAR(session->snapshot()->device.nearest.distance, 0.02, 1e-6);
  const std::uint64_t moves = session->snapshot()->device.moves;
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, [&](const auto& s) { return s.device.moves > moves; }));
  // Contact mode ends soon after the operator rests, but its configurations stay in the roadmap.
  EXPECT_TRUE(waitFor(*session, [](const auto& s) { return s.counts.contactConfigurations > 0; }));
}

TEST_P(SessionConformance, TheObjectCanBePutSomewhere) {
  const auto session = make(sessionConfig(closedProblem()));
  const Pose place = Pose::translation({-1.0, 0.5, 0.5});
  session->post(command::SetDevicePose{place});
  EXPECT_TRUE(waitFor(*session, [&](const auto& s) { return s.device.q_device == place; }));
}

TEST_P(SessionConformance, WakesTheWindowUp) {
  const auto session = make(sessionConfig(closedProblem()));
  std::atomic<int> calls{0};
  session->setWakeUp([&] { ++calls; });
  session->post(command::Start{});
  EXPECT_TRUE(waitFor(*session, [&](const auto&) { return calls > 0; }));
  session->setWakeUp({});
}

std::string testName(const testing::TestParamInfo<std::pair<const char*, Maker>>& parameter) {
  return parameter.param.first;
}

TEST_P(SessionConformance, ThePathIsSmoothedAndGivenBackAsPlanned) {
  const Problem problem = windowProblem();
  const auto session = make(sessionConfig(problem));
  session->post(command::SmoothPath{100});  // there is no path to smooth yet
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, hasEnded));
  const auto planned = session->snapshot()->path;
  ASSERT_NE(planned, nullptr);
  EXPECT_EQ(planned->certificate.edges.size() + 1, planned->points.size());
  session->post(command::SmoothPath{200});
  ASSERT_TRUE(waitFor(*session, [&](const SessionSnapshot& s) { return s.path != planned; }));
  const auto smooth = session->snapshot()->path;
  const auto lengthOf = [&](const Path& path) {
    double sum = 0.0;
    for (const double part : path.lengthByAuthor(problem.metric())) sum += part;
    return sum;
  };
  EXPECT_LT(lengthOf(*smooth), lengthOf(*planned));
  EXPECT_TRUE(session->snapshot()->smoothed);
  EXPECT_EQ(smooth->certificate.status, CertificateStatus::Certified);
  session->post(command::SmoothPath{0});
  ASSERT_TRUE(waitFor(*session, [&](const SessionSnapshot& s) { return s.path != smooth; }));
  EXPECT_EQ(session->snapshot()->path->configurations(), planned->configurations());
  EXPECT_FALSE(session->snapshot()->smoothed);
}

TEST_P(SessionConformance, APathFromElsewhereIsTakenWhereItHolds) {
  const Problem problem = windowProblem();
  const auto first = make(sessionConfig(problem));
  first->post(command::Start{});
  ASSERT_TRUE(waitFor(*first, hasEnded));
  const auto found = first->snapshot()->path;
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(first->snapshot()->provenance.planner, "contact-birrt");

  const auto session = make(sessionConfig(problem));
  session->post(command::ExaminePath{found->points, {"birrt", 77}});
  ASSERT_TRUE(waitFor(*session, hasEnded));
  SnapshotPtr snapshot = session->snapshot();
  EXPECT_EQ(snapshot->state, SessionState::Solved);
  EXPECT_EQ(snapshot->run, 0U);
  EXPECT_TRUE(snapshot->log.empty());
  EXPECT_EQ(snapshot->path->configurations(), found->configurations());
  EXPECT_EQ(snapshot->path->certificate.status, CertificateStatus::Certified);
  EXPECT_EQ(snapshot->provenance.planner, "birrt");
  EXPECT_EQ(snapshot->provenance.seed, 77U);

  session->post(command::SmoothPath{200});
  ASSERT_TRUE(waitFor(*session, [&](const SessionSnapshot& s) { return s.smoothed; }));
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, [](const SessionSnapshot& s) { return s.run == 1 && hasEnded(s); }));
  const auto own = session->snapshot()->path;
  session->post(command::ExaminePath{{{problem.start, Author::Computer}}, {}});  // too late: a run has begun
  session->post(command::SetSeed{5});
  ASSERT_TRUE(waitFor(*session, [](const SessionSnapshot& s) { return s.seed == 5; }));
  EXPECT_EQ(session->snapshot()->path, own);
  EXPECT_EQ(session->snapshot()->refused, nullptr);
}

TEST_P(SessionConformance, APathFromElsewhereIsRefusedWhereItIsBlockedUntilARunBegins) {
  const Problem problem = closedProblem();
  const auto session = make(sessionConfig(problem));
  const std::vector<PathPoint> straight{{problem.start, Author::Computer},
                                        {std::get<Pose>(problem.goal), Author::Computer}};
  session->post(command::ExaminePath{straight, {}});
  ASSERT_TRUE(waitFor(*session, [](const SessionSnapshot& s) { return s.refused != nullptr; }));
  const SnapshotPtr snapshot = session->snapshot();
  EXPECT_EQ(snapshot->state, SessionState::Idle);
  EXPECT_EQ(snapshot->path, nullptr);
  ASSERT_EQ(snapshot->refused->blocked.size(), 1U);
  EXPECT_EQ(snapshot->refused->blocked.front().nearest.body, 0);
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, [](const SessionSnapshot& s) { return s.run == 1; }));
  EXPECT_EQ(session->snapshot()->refused, nullptr);
}

TEST(ThreadedSession, SmoothingTellsHowFarItIsAndAStopLeavesThePath) {
  const auto session = makeThreadedSession(sessionConfig(windowProblem()));
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, hasEnded));
  const auto planned = session->snapshot()->path;
  ASSERT_NE(planned, nullptr);
  session->post(command::SmoothPath{100'000'000});
  ASSERT_TRUE(waitFor(*session, [](const SessionSnapshot& s) { return s.pathWork.has_value(); }));
  session->post(command::Stop{});
  ASSERT_TRUE(waitFor(*session, [](const SessionSnapshot& s) { return !s.pathWork; }));
  EXPECT_EQ(session->snapshot()->path, planned);
  EXPECT_EQ(session->snapshot()->state, SessionState::Solved);
  EXPECT_FALSE(session->snapshot()->smoothed);
}

INSTANTIATE_TEST_SUITE_P(Both, SessionConformance,
                         testing::Values(std::pair<const char*, Maker>{"lockstep", &makeLockstep},
                                         std::pair<const char*, Maker>{"threaded", &makeThreadedSession}),
                         testName);

}  // namespace
}  // namespace glissade
