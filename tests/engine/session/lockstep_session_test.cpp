#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "engine/session/session_with_planners.h"
#include "tests/engine/support/session_support.h"

namespace glissade {
namespace {

RoadmapChunks grow(std::uint64_t chunk, std::uint64_t total) {
  const auto session =
      makeLockstepSession(sessionConfig(closedProblem(), std::make_unique<HomingDevice>(Vector3(-0.35, 0.5, 0.2))));
  session->post(command::Start{});
  session->post(command::SetParameter{ParameterId::Alpha, 0.5});
  for (std::uint64_t done = 0; done < total; done += chunk) session->advance(chunk);
  EXPECT_EQ(session->snapshot()->counts.steps, total);
  return session->snapshot()->roadmap;
}

TEST(LockstepSession, TheRoadmapIsTheSameBitByBitHoweverItIsAdvanced) {
  const auto reference = allNodes(grow(200, 200));
  for (const std::uint64_t chunk : {1U, 7U - 2U, 50U}) {
    const auto nodes = allNodes(grow(chunk, 200));
    ASSERT_EQ(nodes.size(), reference.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_EQ(nodes[i].q, reference[i].q);
  }
}

TEST(LockstepSession, AStepIsAFortiethOfASecondOfTheOperatorsTime) {
  const auto session =
      makeLockstepSession(sessionConfig(closedProblem(), std::make_unique<HomingDevice>(Vector3(1.5, 0.0, 0.0))));
  session->post(command::Start{});
  session->advance(40);
  EXPECT_DOUBLE_EQ(session->snapshot()->virtualSeconds, 1.0);
  // The hand moves at 1 m/s for one second from x = -1.5.
  EXPECT_NEAR(session->snapshot()->device.q_device.position.x(), -0.5, 1e-9);
}

TEST(LockstepSession, AStopTokenEndsAnAdvance) {
  const auto session = makeLockstepSession(sessionConfig(closedProblem()));
  session->post(command::Start{});
  StopSource source;
  source.requestStop();
  session->advance(1000, source.token());
  EXPECT_LE(session->snapshot()->counts.steps, 1U);
  EXPECT_EQ(session->snapshot()->state, SessionState::Planning);
}

/// Works until it is stopped, in the middle of its first step.
class EndlessStep final : public Planner {
 public:
  bool solve(PlannerHost& host) override {
    while (!host.stopToken().stopRequested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return false;
  }
  const std::vector<RoadmapNode>& nodes() const override { return nodes_; }
  const std::vector<RoadmapEdge>& edges() const override { return edges_; }
  const std::vector<std::uint32_t>& droppedEdges() const override { return dropped_; }
  const PlannerCounts& counts() const override { return counts_; }
  const Path* path() const override { return nullptr; }
  std::optional<Diagnostic> failure() const override { return std::nullopt; }

 private:
  std::vector<RoadmapNode> nodes_;
  std::vector<RoadmapEdge> edges_;
  std::vector<std::uint32_t> dropped_;
  PlannerCounts counts_;
};

TEST(LockstepSession, TheTimeLimitEndsARunWithinItsFirstStep) {
  PlannerRegistry planners = makePlannerRegistry();
  planners.add({"endless", Message("Endless"), {}, false, true, [](const Problem&, std::uint64_t) {
                  return std::make_unique<EndlessStep>();
                }});
  SessionConfig config = sessionConfig(closedProblem());
  config.plannerId = "endless";
  ASSERT_TRUE(config.parameters.set(ParameterId::TimeLimit, 0.02));
  const auto session = makeLockstepSession(std::move(config), std::move(planners));
  session->post(command::Start{});
  session->advance(10);
  ASSERT_EQ(session->snapshot()->state, SessionState::Failed);
  EXPECT_EQ(session->snapshot()->problem->kind, ErrorKind::LimitReached);
}

TEST(LockstepSession, TheLogHoldsWhatThePlannerSawOfTheOperator) {
  const auto session =
      makeLockstepSession(sessionConfig(closedProblem(), std::make_unique<HomingDevice>(Vector3(-0.35, 0.5, 0.2))));
  session->post(command::Start{});
  session->advance(100);
  session->post(command::Stop{});
  session->advance(0);
  const RunLogParts parts = session->snapshot()->log;
  ASSERT_FALSE(parts.empty());
  const auto stream = joined(parts).operatorStream;
  ASSERT_FALSE(stream.empty());
  EXPECT_EQ(stream.front().q_device, closedProblem().start);
  for (std::size_t i = 1; i < stream.size(); ++i) {
    EXPECT_GT(stream[i].step, stream[i - 1].step);
    EXPECT_NE(stream[i].q_device, stream[i - 1].q_device);
  }
}

}  // namespace
}  // namespace glissade
