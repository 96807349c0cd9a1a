// Tests the properties of the adapter beyond the contract of every planner (planner_conformance_test.cpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "engine/planning/ompl/ompl_planner.h"
#include "engine/study/benchmarks/peer_planners.h"
#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

constexpr std::uint64_t kSteps = 100000;

class OmplPlannerTest : public testing::TestWithParam<OmplAlgorithm> {
 protected:
  std::unique_ptr<OmplPlanner> make(const Problem& problem, std::uint64_t seed = 1) const {
    return std::make_unique<OmplPlanner>(problem, seed, GetParam());
  }
};

/// Cells of half a metre in the window's bounds with |y| and |z| below 0.75.
SamplingRegionPtr throughTheWindow(const Problem& problem) {
  CellGrid grid;
  grid.frame = CellFrame::covering(problem.bounds);
  grid.level = 4;
  grid.counts = {16, 16, 16};
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    const Vector3 centre = grid.centre(cell);
    if (std::abs(centre.y()) < 0.75 && std::abs(centre.z()) < 0.75) cells.push_back(cell);
  }
  return std::make_shared<const SamplingRegion>(grid, cells);
}

void expectSameRoadmap(const Planner& a, const Planner& b) {
  ASSERT_EQ(a.nodes().size(), b.nodes().size());
  ASSERT_EQ(a.edges().size(), b.edges().size());
  for (std::size_t i = 0; i < a.nodes().size(); ++i) EXPECT_EQ(a.nodes()[i].q, b.nodes()[i].q) << "node " << i;
  for (std::size_t i = 0; i < a.edges().size(); ++i) {
    EXPECT_EQ(a.edges()[i].from, b.edges()[i].from);
    EXPECT_EQ(a.edges()[i].to, b.edges()[i].to);
  }
}

TEST_P(OmplPlannerTest, SolvesTheWindowWithACertifiedPath) {
  const Problem problem = windowProblem();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    TestHost host(problem, kSteps);
    const auto planner = make(problem, seed);
    ASSERT_TRUE(planner->solve(host)) << "seed " << seed;
    const Path* path = planner->path();
    ASSERT_NE(path, nullptr);
    EXPECT_EQ(path->points.front().q, problem.start);
    EXPECT_EQ(path->points.back().q, std::get<Pose>(problem.goal));
    EXPECT_EQ(path->certificate.status, CertificateStatus::Certified);
    EXPECT_GE(path->certificate.provedClearance, host.values[ParameterId::RequiredClearance]);
    EXPECT_FALSE(planner->failure());
  }
}

TEST_P(OmplPlannerTest, CountsEveryDrawAndAStepForEach) {
  const Problem problem = windowProblem();
  TestHost host(problem, kSteps);
  const auto planner = make(problem);
  ASSERT_TRUE(planner->solve(host));
  const PlannerCounts& counts = planner->counts();
  EXPECT_GE(counts.steps, kSteps - host.stepsLeft) << "what is left of the last piece is taken at once";
  EXPECT_GT(counts.randomConfigurations, 0U);
  EXPECT_GE(counts.steps, counts.randomConfigurations);  // a piece may try only the goal
  EXPECT_GE(counts.queries.collision, counts.iterations);
  EXPECT_EQ(counts.nodes, planner->nodes().size());
  EXPECT_EQ(counts.edges, 2 * planner->edges().size());
  EXPECT_TRUE(planner->droppedEdges().empty());
}

TEST_P(OmplPlannerTest, TheRoadmapBeginsWithTheStartAndIsAppendedTo) {
  const Problem problem = closedProblem();
  const auto planner = make(problem);
  std::vector<RoadmapNode> before = planner->nodes();
  ASSERT_EQ(before.size(), 1U);
  for (int part = 0; part < 20; ++part) {
    TestHost host(problem, 50);
    EXPECT_FALSE(planner->solve(host));
    ASSERT_GE(planner->nodes().size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) ASSERT_EQ(planner->nodes()[i].q, before[i].q);
    EXPECT_EQ(planner->counts().nodes, planner->nodes().size());
    EXPECT_EQ(planner->counts().edges, 2 * planner->edges().size());
    before = planner->nodes();
  }
  EXPECT_EQ(before.front().q, problem.start);
  EXPECT_GT(before.size(), 20U);
}

TEST_P(OmplPlannerTest, SameSeedGrowsTheSameRoadmapWhateverOtherPlannersDo) {
  const Problem problem = closedProblem();
  constexpr std::uint64_t kSome = 1500;
  const auto alone = make(problem, 5);
  TestHost host(problem, kSome);
  EXPECT_FALSE(alone->solve(host));
  // Other planners with other seeds use OMPL's global seeds at the same time.
  std::vector<std::unique_ptr<OmplPlanner>> planners(4);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < planners.size(); ++i) {
    threads.emplace_back([&, i] {
      planners[i] = make(problem, i % 2 == 0 ? 5 : 6 + i);
      TestHost ownHost(problem, kSome);
      planners[i]->solve(ownHost);
    });
  }
  for (std::thread& thread : threads) thread.join();
  expectSameRoadmap(*alone, *planners[0]);
  expectSameRoadmap(*alone, *planners[2]);
}

TEST_P(OmplPlannerTest, InterruptionsChangeNeitherNodesNorEdges) {
  const Problem problem = closedProblem();
  constexpr std::uint64_t kSome = 600;
  const auto whole = make(problem, 2);
  TestHost host(problem, kSome);
  whole->solve(host);
  const auto pieces = make(problem, 2);
  for (std::uint64_t step = 0; step < kSome; ++step) {
    TestHost one(problem, 1);
    pieces->solve(one);
  }
  EXPECT_EQ(whole->counts().steps, pieces->counts().steps);
  expectSameRoadmap(*whole, *pieces);
}

TEST_P(OmplPlannerTest, AStopEndsItQuickly) {
  const Problem problem = closedProblem();
  StopSource source;
  const auto planner = make(problem);
  TestHost host(problem, 1000000000);
  // The host of a session ends the run after the step in which it was stopped.
  class StoppingHost final : public PlannerHost {
   public:
    explicit StoppingHost(TestHost& host) : host_(host) {}
    std::optional<OperatorSample> operatorSample() override { return std::nullopt; }
    const ParameterValues& parameters() const override { return host_.values; }
    bool afterStep() override { return !host_.stop.stopRequested(); }
    const StopToken& stopToken() const override { return host_.stop; }

   private:
    TestHost& host_;
  } stopping(host);
  host.stop = source.token();
  std::chrono::steady_clock::time_point asked;
  std::thread user([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    asked = std::chrono::steady_clock::now();
    source.requestStop();
  });
  EXPECT_FALSE(planner->solve(stopping));
  const auto ended = std::chrono::steady_clock::now();
  user.join();
  EXPECT_LT(std::chrono::duration<double>(ended - asked).count(), 0.25);  // 50 ms on an otherwise idle machine
}

TEST_P(OmplPlannerTest, DrawsInTheRegionOnly) {
  Problem problem = windowProblem();
  problem.region = throughTheWindow(problem);
  TestHost host(problem, kSteps);
  const auto planner = make(problem);
  ASSERT_TRUE(planner->solve(host));
  // The region is convex and contains start and goal, so that it contains the motions between the draws.
  for (const RoadmapNode& node : planner->nodes()) EXPECT_TRUE(problem.region->contains(node.q.position));
}

TEST_P(OmplPlannerTest, GivesUpWhereNoGoalIsWithinTheBounds) {
  Problem problem = windowProblem();
  problem.goal = Pose::translation({5.0, 0.0, 0.0});
  TestHost host(problem, 100);
  const auto planner = make(problem);
  EXPECT_FALSE(planner->solve(host));
  EXPECT_TRUE(planner->failure());
}

std::string testName(const testing::TestParamInfo<OmplAlgorithm>& parameter) {
  switch (parameter.param) {
    case OmplAlgorithm::RrtConnect: return "RrtConnect";
    case OmplAlgorithm::Bkpiece: return "Bkpiece";
    case OmplAlgorithm::Prm: return "Prm";
    case OmplAlgorithm::Est: return "Est";
    case OmplAlgorithm::Rrt: return "Rrt";
    case OmplAlgorithm::Trrt: return "Trrt";
    case OmplAlgorithm::BiTrrt: return "BiTrrt";
  }
  return "";
}

INSTANTIATE_TEST_SUITE_P(Algorithms, OmplPlannerTest,
                         testing::Values(OmplAlgorithm::RrtConnect, OmplAlgorithm::Bkpiece, OmplAlgorithm::Prm,
                                         OmplAlgorithm::Est),
                         testName);

/// Planners of unmodified OMPL.
class OmplPeerTest : public testing::TestWithParam<OmplAlgorithm> {
 protected:
  std::unique_ptr<OmplPlanner> make(const Problem& problem) const {
    return std::make_unique<OmplPlanner>(problem, 1, GetParam(), OmplManner::AsItIs);
  }
};

/// The start and the goal on the two sides of a thin wall with little room around it.
Problem thinWallProblem() {
  Problem problem = windowProblem();
  problem.world = CollisionWorld::build({boxBody("wall", {0.002, 3.9, 3.9}, Pose::identity())},
                                        std::make_shared<const TriangleMesh>(makeBox({0.01, 0.01, 0.01})));
  problem.goal = Pose::translation({1.5, 0.0, 0.0});
  return problem;
}

TEST_P(OmplPeerTest, ItsFirstPathIsTheResult) {
  const Problem problem = windowProblem();
  TestHost host(problem, kSteps);
  ASSERT_TRUE(host.values.set(ParameterId::OmplResolution, 5e-3));  // BiTRRT takes half a minute with a finer value
  const auto planner = make(problem);
  const bool solved = planner->solve(host);
  EXPECT_NE(solved, planner->failure().has_value());
  EXPECT_EQ(planner->counts().rejectedPaths, solved ? 0U : 1U);
  EXPECT_GT(planner->counts().queries.collision, 0U);
  EXPECT_EQ(planner->counts().nodes, planner->nodes().size());
  if (solved) {
    EXPECT_EQ(planner->path()->certificate.status, CertificateStatus::Certified);
  }
}

TEST_P(OmplPeerTest, ACoarseResolutionTunnelsAndIsRefused) {
  const Problem problem = thinWallProblem();
  TestHost host(problem, kSteps);
  ASSERT_TRUE(host.values.set(ParameterId::OmplResolution, 0.05));
  const auto planner = make(problem);
  EXPECT_FALSE(planner->solve(host));
  EXPECT_EQ(planner->path(), nullptr);
  EXPECT_EQ(planner->counts().rejectedPaths, 1U);
  ASSERT_TRUE(planner->failure());
  EXPECT_EQ(planner->failure()->kind, ErrorKind::NoPath);
}

TEST_P(OmplPeerTest, TheRangeIsTheLongestEdge) {
  const Problem problem = closedProblem();
  const auto longest = [&](double range) {
    TestHost host(problem, 2000);
    EXPECT_TRUE(host.values.set(ParameterId::OmplRange, range));
    const auto planner = make(problem);
    planner->solve(host);
    planner->completeRoadmap();
    double most = 0.0;
    for (const RoadmapEdge& edge : planner->edges()) {
      most = std::max(most, (planner->nodes()[edge.from].q.position - planner->nodes()[edge.to].q.position).norm());
    }
    return most;
  };
  const double extent = problem.bounds.diagonal().norm() + std::acos(-1.0) / 2.0;  // extent by OMPL, with weights of 1
  const double bound = std::sqrt(3.0) * 0.02 * extent;  // some of its samplers draw from a cube
  EXPECT_LE(longest(0.02), bound + 1e-9);
  EXPECT_GT(longest(0.0), longest(0.02)) << "the default is a fifth";
}

INSTANTIATE_TEST_SUITE_P(Algorithms, OmplPeerTest,
                         testing::Values(OmplAlgorithm::RrtConnect, OmplAlgorithm::Rrt, OmplAlgorithm::Trrt,
                                         OmplAlgorithm::BiTrrt, OmplAlgorithm::Bkpiece),
                         testName);

TEST(OmplPlanners, AreInBothRegistries) {
  for (const char* id : {"ompl-rrtconnect", "ompl-bkpiece", "ompl-prm", "ompl-est"}) {
    EXPECT_NE(makePlannerRegistry().find(id), nullptr) << id;
    EXPECT_NE(makeLocalPlannerRegistry().find(id), nullptr) << id;
  }
}

/// Peers belong to benchmarks: the product's registries have none.
TEST(OmplPlanners, OfBenchmarksAreInNeitherRegistry) {
  PlannerRegistry peers;
  registerPeerPlanners(peers);
  EXPECT_EQ(idsOf(peers),
            (std::vector<std::string>{"peer-rrtconnect", "peer-rrt", "peer-trrt", "peer-bitrrt", "peer-bkpiece"}));
  for (const std::string& id : idsOf(peers)) {
    EXPECT_EQ(makePlannerRegistry().find(id), nullptr) << id;
    EXPECT_EQ(makeLocalPlannerRegistry().find(id), nullptr) << id;
    EXPECT_NE(makePlannerRegistryWithPeers().find(id), nullptr) << id;
  }
  EXPECT_EQ(toString(unknownPlanner("peer-rrt", {}).reason),
            "'peer-rrt' is a planner for comparison, which only glissade-cli has");
  EXPECT_EQ(toString(unknownPlanner("warp", {}).reason), "there is no planner 'warp'");
}

}  // namespace
}  // namespace glissade
