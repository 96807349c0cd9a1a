// Tests members of the automatic planner that work in parallel.
#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "engine/planning/automatic/automatic_planner.h"
#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

TestHost hostWithSlots(const Problem& problem, int slots, std::uint64_t steps) {
  TestHost host(problem, steps);
  EXPECT_TRUE(host.values.set(ParameterId::Slots, slots));
  return host;
}

/// Two windows that are not aligned, so that no direct motion leads through both.
Problem twoWindows() {
  Problem problem = windowProblem();
  std::vector<RigidBody> walls = problem.world->obstacles();
  for (RigidBody wall : problem.world->obstacles()) {
    wall.id = BodyId(wall.id.text() + " behind");
    wall.X_WB.position += Vector3(0.9, 0.7, -0.7);
    walls.push_back(wall);
  }
  problem.world = CollisionWorld::build(walls, std::make_shared<const TriangleMesh>(problem.world->object()));
  return problem;
}

/// The complete result of a run.
struct Trace {
  bool solved;
  std::string member;
  std::vector<Pose> path;
  std::vector<Pose> nodes;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::vector<std::uint64_t> counts;

  friend bool operator==(const Trace& a, const Trace& b) {
    return a.solved == b.solved && a.member == b.member && a.path == b.path && a.nodes == b.nodes &&
           a.edges == b.edges && a.counts == b.counts;
  }
};

Trace traceOf(const Problem& problem, std::uint64_t seed, int slots, std::size_t threads, std::uint64_t steps) {
  TestHost host = hostWithSlots(problem, slots, steps);
  AutomaticPlanner planner(problem, seed, threads);
  Trace trace;
  trace.solved = planner.solve(host);
  planner.completeRoadmap();
  trace.member = planner.member();
  if (trace.solved) trace.path = planner.path()->configurations();
  for (const RoadmapNode& node : planner.nodes()) trace.nodes.push_back(node.q);
  for (const RoadmapEdge& edge : planner.edges()) trace.edges.emplace_back(edge.from, edge.to);
  const PlannerCounts& counts = planner.counts();
  trace.counts = {counts.iterations,       counts.steps,         counts.randomConfigurations, counts.queries.collision,
                  counts.queries.distance, counts.queries.motion};
  return trace;
}

TEST(Slots, SeedAndSlotsDecideTheResultNotTheThreads) {
  const Problem problem = twoWindows();
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Trace alone = traceOf(problem, seed, 4, 1, 1'000'000);
    EXPECT_TRUE(alone.solved);
    for (const std::size_t threads : {2U, 4U}) {
      EXPECT_TRUE(traceOf(problem, seed, 4, threads, 1'000'000) == alone) << threads << " threads, seed " << seed;
    }
  }
}

/// The search is long enough for the members that enter late, several lives of the others, and OMPL's members beside
/// ours.
TEST(Slots, ALongSearchIsTheSameOnAnyNumberOfThreads) {
  const Problem problem = closedProblem();
  const Trace alone = traceOf(problem, 1, 4, 1, 50'000);
  EXPECT_FALSE(alone.solved);
  EXPECT_GT(alone.nodes.size(), 1000U);
  EXPECT_TRUE(traceOf(problem, 1, 4, 4, 50'000) == alone);
}

TEST(Slots, OtherSlotsAreAnotherSearch) {
  const Problem problem = closedProblem();
  const auto nodes = [&](int slots) { return traceOf(problem, 1, slots, 4, 8'000).nodes; };
  EXPECT_NE(nodes(1), nodes(2));
  EXPECT_NE(nodes(2), nodes(3));
}

TEST(Slots, TheHostIsAskedOnceForEachTurn) {
  const Problem problem = closedProblem();
  for (const int slots : {1, 4}) {
    TestHost host = hostWithSlots(problem, slots, 5'000);
    AutomaticPlanner planner(problem, 1);
    planner.solve(host);
    EXPECT_LE(planner.counts().steps, 5'000U);
    EXPECT_GT(planner.counts().steps, 4'900U);
  }
}

TEST(Slots, NamesAllWhoseTurnItIs) {
  const Problem problem = closedProblem();
  TestHost host = hostWithSlots(problem, 4, 5'000);
  AutomaticPlanner planner(problem, 1);
  planner.solve(host);
  const std::string names = planner.member();
  const std::size_t comma = names.find(", ");
  ASSERT_NE(comma, std::string::npos) << names;
  EXPECT_NE(names.substr(0, comma), names.substr(comma + 2));
}

/// Ends the run after a stop, as a session's host does.
class StoppableHost final : public PlannerHost {
 public:
  explicit StoppableHost(const TestHost& host) : host_(host) {}
  std::optional<OperatorSample> operatorSample() override { return std::nullopt; }
  const ParameterValues& parameters() const override { return host_.values; }
  bool afterStep() override { return !stop.token().stopRequested(); }
  const StopToken& stopToken() const override { return token_; }

  StopSource stop;

 private:
  const TestHost& host_;
  StopToken token_ = stop.token();
};

TEST(Slots, AStopFromAnotherThreadEndsAllOfThem) {
  const Problem problem = closedProblem();
  const TestHost parameters = hostWithSlots(problem, 4, 1);
  StoppableHost host(parameters);
  AutomaticPlanner planner(problem, 1, 4);
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    host.stop.requestStop();
  });
  EXPECT_FALSE(planner.solve(host));
  other.join();
  EXPECT_EQ(planner.path(), nullptr);
  EXPECT_FALSE(planner.failure());
}

}  // namespace
}  // namespace glissade
