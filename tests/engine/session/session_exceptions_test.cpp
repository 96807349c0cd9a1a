// Exceptions of planners and devices end a run and nothing else, in both sessions.
#include <gtest/gtest.h>

#include <tuple>

#include "engine/session/session_with_planners.h"
#include "tests/engine/support/session_support.h"
#include "tests/engine/support/thrown_exceptions.h"

namespace glissade {
namespace {

using test::kThrown;
using test::Thrown;

/// Place where the planner of these tests throws.
enum class Place { Constructor, Solve, Nodes, CompleteRoadmap };

class ThrowingPlanner final : public Planner {
 public:
  ThrowingPlanner(const Problem& problem, Place place, const Thrown& thrown)
      : place_(place), thrown_(thrown), nodes_{{problem.start, Author::Computer, TreeSide::Start}} {
    if (place == Place::Constructor) thrown.raise();
  }

  bool solve(PlannerHost& host) override {
    while (counts_.steps < 5) {
      ++counts_.steps;
      nodes_.push_back(nodes_.front());
      counts_.nodes = nodes_.size();
      if (!host.afterStep()) return false;
    }
    throwing_ = true;
    if (place_ == Place::Solve) thrown_.raise();
    host.afterStep();  // reads the nodes
    failure_ = Diagnostic{ErrorKind::NoPath, "", "", Message("it gives up"), {}};
    return false;
  }
  void completeRoadmap() override {
    if (place_ == Place::CompleteRoadmap) thrown_.raise();
  }
  const std::vector<RoadmapNode>& nodes() const override {
    if (throwing_ && place_ == Place::Nodes) thrown_.raise();
    return nodes_;
  }
  const std::vector<RoadmapEdge>& edges() const override { return edges_; }
  const std::vector<std::uint32_t>& droppedEdges() const override { return dropped_; }
  const PlannerCounts& counts() const override { return counts_; }
  const Path* path() const override { return nullptr; }
  std::optional<Diagnostic> failure() const override { return failure_; }

 private:
  Place place_;
  const Thrown& thrown_;
  bool throwing_ = false;
  std::vector<RoadmapNode> nodes_;
  std::vector<RoadmapEdge> edges_;
  std::vector<std::uint32_t> dropped_;
  PlannerCounts counts_;
  std::optional<Diagnostic> failure_;
};

using Parameter = std::tuple<bool, Place, Thrown>;

std::unique_ptr<Session> makeSession(bool threaded, SessionConfig config,
                                     PlannerRegistry planners = makePlannerRegistry()) {
  if (threaded) return makeThreadedSession(std::move(config), std::move(planners));
  return makeLockstepSession(std::move(config), std::move(planners));
}

class SessionExceptions : public testing::TestWithParam<Parameter> {};

TEST_P(SessionExceptions, EndTheRunAndTheNextStartPlans) {
  const auto& [threaded, place, thrown] = GetParam();
  SessionConfig config = sessionConfig(windowProblem());
  PlannerRegistry planners = makePlannerRegistry();
  planners.add({"throwing",
                Message("Throwing"),
                {},
                false,
                true,
                [place = place, &thrown = thrown](const Problem& problem, std::uint64_t) {
                  return std::make_unique<ThrowingPlanner>(problem, place, thrown);
                }});
  config.plannerId = "throwing";
  const auto session = makeSession(threaded, std::move(config), std::move(planners));
  for (std::uint64_t run = 1; run < 3; ++run) {
    session->post(command::Start{});
    ASSERT_TRUE(waitFor(*session, [&](const SessionSnapshot& s) { return s.run == run && hasEnded(s); }));
    const SnapshotPtr snapshot = session->snapshot();
    EXPECT_EQ(snapshot->state, SessionState::Failed);
    ASSERT_TRUE(snapshot->problem);
    EXPECT_EQ(snapshot->problem->kind, thrown.kind);
    EXPECT_NE(toString(snapshot->problem->reason)
                  .find(place == Place::Constructor ? "while starting the planner" : "while p"),
              std::string::npos)
        << toString(snapshot->problem->reason);
    EXPECT_FALSE(snapshot->problem->advice.empty());
    // Published nodes are not lost.
    if (place == Place::Solve) {
      EXPECT_EQ(allNodes(snapshot->roadmap).size(), 6U);
    }
  }
  session->post(command::SetPlanner{"contact-birrt"});
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, [](const SessionSnapshot& s) { return s.run == 3 && hasEnded(s); }));
  EXPECT_EQ(session->snapshot()->state, SessionState::Solved);
  EXPECT_FALSE(session->snapshot()->problem);
}

std::string nameOf(const testing::TestParamInfo<Parameter>& parameter) {
  static const char* places[] = {"Constructor", "Solve", "Nodes", "CompleteRoadmap"};
  const auto& [threaded, place, thrown] = parameter.param;
  return std::string(threaded ? "Threaded" : "Lockstep") + places[static_cast<int>(place)] + thrown.name;
}

INSTANTIATE_TEST_SUITE_P(Both, SessionExceptions,
                         testing::Combine(testing::Bool(),
                                          testing::Values(Place::Constructor, Place::Solve, Place::Nodes,
                                                          Place::CompleteRoadmap),
                                          testing::ValuesIn(kThrown)),
                         nameOf);

class ThrowingDevice final : public OperatorDevice {
 public:
  explicit ThrowingDevice(void (*raise)()) : raise_(raise) {}
  Pose advance(double, const OperatorView& view, const Box3&) override {
    raise_();
    return view.q_device;
  }

 private:
  void (*raise_)();
};

class DeviceExceptions : public testing::TestWithParam<std::tuple<bool, Thrown>> {};

TEST_P(DeviceExceptions, TakeTheDeviceAwayAndPlanningGoesOn) {
  const auto& [threaded, thrown] = GetParam();
  const auto session =
      makeSession(threaded, sessionConfig(windowProblem(), std::make_unique<ThrowingDevice>(thrown.raise)));
  ASSERT_TRUE(waitFor(*session, [](const SessionSnapshot& s) { return s.problem.has_value(); }));
  EXPECT_EQ(session->snapshot()->problem->kind, thrown.kind);
  EXPECT_EQ(toString(session->snapshot()->problem->location), "device");
  session->post(command::Start{});
  ASSERT_TRUE(waitFor(*session, hasEnded));
  EXPECT_EQ(session->snapshot()->state, SessionState::Solved);
}

INSTANTIATE_TEST_SUITE_P(Both, DeviceExceptions, testing::Combine(testing::Bool(), testing::ValuesIn(kThrown)),
                         [](const testing::TestParamInfo<std::tuple<bool, Thrown>>& parameter) {
                           return std::string(std::get<0>(parameter.param) ? "Threaded" : "Lockstep") +
                                  std::get<1>(parameter.param).name;
                         });

}  // namespace
}  // namespace glissade
