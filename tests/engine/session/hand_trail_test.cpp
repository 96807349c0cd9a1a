// Tests that the way of a hand is never lost (strategy "by-hand"): environment 2, whose slot no straight motion
// crosses.
#include <gtest/gtest.h>

#include "engine/base/random_stream.h"
#include "engine/operator/sliding_hand.h"
#include "engine/planning/path_certificate.h"
#include "engine/session/replay_session.h"
#include "engine/session/run_comparison.h"
#include "tests/engine/support/independent_check.h"
#include "tests/engine/support/loaded_scenario.h"
#include "tests/engine/support/session_support.h"

namespace glissade {
namespace {

/// A person's hand that leads along a route. It goes on to the next point when it is there, or where obstacles have
/// held it back for a second.
class LeadingHand final : public OperatorDevice {
 public:
  /// `speed`: in radii of the object per second.
  LeadingHand(std::vector<Pose> route, const Se3Metric& metric, double speed)
      : route_(std::move(route)), metric_(metric), speed_(speed * metric.radius()) {}

  Pose advance(double dt, const OperatorView& view, const Box3& /*bounds*/) override {
    const double left = metric_.distance(view.q_device, route_[next_]);
    waited_ = left < nearest_ - kProgress ? 0.0 : waited_ + dt;
    nearest_ = std::min(nearest_, left);
    if ((left < kThere * metric_.radius() || waited_ > 1.0) && next_ + 1 < route_.size()) {
      ++next_;
      nearest_ = std::numeric_limits<double>::infinity();
      return view.q_device;
    }
    return left > 0.0 ? interpolate(view.q_device, route_[next_], std::min(1.0, speed_ * dt / left)) : view.q_device;
  }
  bool holds() const override { return true; }

 private:
  static constexpr double kThere = 0.005;
  static constexpr double kProgress = 1e-3;

  std::vector<Pose> route_;
  Se3Metric metric_;
  double speed_;
  std::size_t next_ = 0;
  double nearest_ = std::numeric_limits<double>::infinity();
  double waited_ = 0.0;
};

class HandTrail : public testing::TestWithParam<std::uint64_t> {
 protected:
  /// Positions of the way points are off by at most `error` metres, so that the hand leads into the walls.
  std::unique_ptr<LockstepSession> begin(const std::string& strategy, double alpha, double error, double speed) {
    SessionConfig config{problem, environment.parameters, strategy, GetParam(), nullptr};
    EXPECT_TRUE(config.parameters.set(ParameterId::Alpha, alpha));
    std::vector<Pose> shown = route;
    RandomStream random(GetParam(), "errors of the hand");
    for (Pose& q : shown) {
      for (int axis = 0; axis < 3; ++axis) q.position[axis] += random.uniform(-error, error);
    }
    config.device =
        std::make_unique<SlidingHand>(problem.world, std::make_unique<LeadingHand>(shown, problem.metric(), speed));
    auto session = makeLockstepSession(std::move(config));
    session->post(command::Start{});
    session->advance(1);
    session->post(command::SetDevicePose{route.front()});  // as "Show me where to help" does
    return session;
  }

  /// The judge proves the path, and does not take the certificate's word.
  bool isJudgedFree(const Path& path) const {
    const IndependentCheck judge(problem.world->obstacles(), problem.world->object());
    const auto demands = demandsOf(path.points, environment.parameters);
    return judge.check(path.configurations(), demands).status == CertificateStatus::Certified;
  }

  double operatorsShare(const Path& path) const {
    const auto lengths = path.lengthByAuthor(problem.metric());
    return lengths[static_cast<std::size_t>(Author::Operator)] / (lengths[0] + lengths[1] + lengths[2]);
  }

  LoadedScenario environment = test::loadedSample("environment-2");
  const Problem& problem = environment.problem;
  const std::vector<Pose>& route = environment.scenario.wayPoints;
};

INSTANTIATE_TEST_SUITE_P(Seeds, HandTrail, testing::Values(1, 2, 3));

TEST_P(HandTrail, AHandThroughTheSlotLeavesNodesThere) {
  const auto session = begin("by-hand", 0.2, 0.0, 0.3);
  session->advance(1200);
  const SnapshotPtr end = session->snapshot();
  ASSERT_EQ(end->state, SessionState::Solved);
  EXPECT_TRUE(isJudgedFree(*end->path));
  EXPECT_GT(operatorsShare(*end->path), 0.3);
  const auto nodes = allNodes(end->roadmap);
  for (const Pose& q : route) {
    if (q.position.z() > 2.0) continue;  // beyond the slot
    const bool isKept = std::any_of(nodes.begin(), nodes.end(), [&](const RoadmapNode& node) {
      return node.author == Author::Operator && problem.metric().distance(node.q, q) < 0.15;
    });
    EXPECT_TRUE(isKept) << q.position.transpose();
  }
}

TEST_P(HandTrail, AFastHandThatPushesIntoTheWallsNeedsNoComputer) {
  const auto session = begin("by-hand", 0.0, 0.1, 2.0);
  session->advance(2400);
  const SnapshotPtr end = session->snapshot();
  ASSERT_EQ(end->state, SessionState::Solved);
  EXPECT_EQ(end->counts.randomConfigurations, 0U);
  EXPECT_TRUE(isJudgedFree(*end->path));
}

TEST_P(HandTrail, TheComputerFinishesFromTheWayOfTheHand) {
  const auto session = begin("by-hand", 0.0, 0.02, 0.3);
  session->advance(380);
  ASSERT_EQ(session->snapshot()->state, SessionState::Planning);
  session->post(command::SetParameter{ParameterId::Alpha, 1.0});
  session->advance(200'000);
  const SnapshotPtr end = session->snapshot();
  ASSERT_EQ(end->state, SessionState::Solved);
  EXPECT_TRUE(isJudgedFree(*end->path));
  RecordProperty("steps", static_cast<int>(end->counts.steps));
  EXPECT_GT(operatorsShare(*end->path), 0.2);
}

TEST_P(HandTrail, ARecordGrowsTheSameRoadmapAgain) {
  const auto session = begin("by-hand", 0.2, 0.02, 0.5);
  session->advance(200);
  session->post(command::SetParameter{ParameterId::Alpha, 1.0});
  session->advance(300);
  session->post(command::SetParameter{ParameterId::Alpha, 0.1});
  session->advance(200);
  session->post(command::Stop{});
  session->advance(1);
  const RunLog log = joined(session->snapshot()->log);
  const auto replay = makeReplaySession(problem, std::make_shared<const RunLog>(log));
  replay->post(command::Start{});
  while (replay->snapshot()->run == 0 || isRunning(*replay->snapshot())) replay->advance(77);
  EXPECT_FALSE(firstDifference(log, joined(replay->snapshot()->log)));
}

TEST(OperatorAlone, NothingIsPlannedBeforeTheHandHasMoved) {
  const LoadedScenario plane = test::loadedSample("sliding-plane");
  SessionConfig config{plane.problem, plane.parameters, "by-hand", 1, nullptr};
  ASSERT_TRUE(config.parameters.set(ParameterId::Alpha, 0.0));
  config.device = std::make_unique<HomingDevice>(plane.problem.start.position);
  const auto session = makeLockstepSession(std::move(config));
  session->post(command::Start{});
  session->advance(1000);
  EXPECT_EQ(session->snapshot()->state, SessionState::Planning);
  EXPECT_EQ(session->snapshot()->counts.nodes, 2U);
}

}  // namespace
}  // namespace glissade
