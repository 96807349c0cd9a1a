// Tests the strategy "interactive": the portfolio with a hand.
#include <gtest/gtest.h>

#include "engine/planning/automatic/automatic_planner.h"
#include "engine/planning/interactive/hand_partner.h"
#include "tests/engine/support/test_host.h"
#include "tests/engine/support/test_worlds.h"

namespace glissade {
namespace {

/// A tunnel with two bends, which uniform draws rarely hit.
Problem bentTunnel() {
  Problem problem = windowProblem();
  std::vector<RigidBody> walls;
  const auto block = [&](const char* name, const Vector3& least, const Vector3& most) {
    walls.push_back(boxBody(name, most - least, Pose::translation((least + most) / 2.0)));
  };
  // Solid for |x| < 1.2, except for a channel of 0.46 m: it enters at (y, z) = (0, 0), goes across to y = 1, and leaves
  // at (1, 0).
  block("below", {-1.2, -2.5, -2.5}, {1.2, 2.5, -0.23});
  block("above", {-1.2, -2.5, 0.23}, {1.2, 2.5, 2.5});
  block("left", {-1.2, -2.5, -0.23}, {1.2, -0.23, 0.23});
  block("right", {-1.2, 1.23, -0.23}, {1.2, 2.5, 0.23});
  block("near", {-1.2, 0.23, -0.23}, {-0.23, 1.23, 0.23});
  block("far", {0.23, -0.23, -0.23}, {1.2, 0.77, 0.23});
  problem.world = CollisionWorld::build(walls, std::make_shared<const TriangleMesh>(problem.world->object()));
  problem.bounds = Box3(Vector3::Constant(-2.4), Vector3::Constant(2.4));
  problem.start = Pose::translation({-2.0, -1.5, 1.0});
  problem.goal = Pose::translation({2.0, -1.5, -1.0});
  return problem;
}

const std::vector<Vector3> kThroughTheTunnel{{-1.8, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1.8, 1, 0}};
const std::vector<Vector3> kElsewhere{{-2.0, 2.0, 2.0}, {-2.0, -2.0, 2.0}, {-2.0, 2.0, -2.0}, {-2.0, -2.0, -2.0}};

/// A hand that moves a hundredth of a metre each step, from the start to one point after the other and back again;
/// no points: it rests.
class WalkingHand final : public PlannerHost {
 public:
  WalkingHand(const Problem& problem, std::vector<Vector3> points, std::uint64_t maxSteps, double stride = 0.01)
      : values(problem.world->objectRadius()),
        points_(std::move(points)),
        stride_(stride),
        stepsLeft_(maxSteps),
        query_(problem.world->makeQuery()) {
    sample_.q_device = problem.start;
    sample_.nearest = query_->nearestObstacle(problem.start);
  }

  std::optional<OperatorSample> operatorSample() override { return sample_; }
  const ParameterValues& parameters() const override { return values; }
  bool afterStep() override {
    move();
    return --stepsLeft_ > 0;
  }
  const StopToken& stopToken() const override { return stop_; }

  ParameterValues values;

 private:
  void move() {
    if (points_.empty()) return;
    const Vector3 way = points_[next_] - sample_.q_device.position;
    if (way.norm() <= stride_) next_ = (next_ + 1) % points_.size();
    sample_.q_device.position += way.normalized() * std::min(stride_, way.norm());
    sample_.nearest = query_->nearestObstacle(sample_.q_device);
    ++sample_.moves;
  }

  std::vector<Vector3> points_;
  double stride_;
  std::size_t next_ = 0;
  std::uint64_t stepsLeft_;
  std::unique_ptr<CollisionQuery> query_;
  OperatorSample sample_;
  StopToken stop_;
};

std::unique_ptr<AutomaticPlanner> interactive(const Problem& problem, std::uint64_t seed, std::size_t threads = 2) {
  return std::make_unique<AutomaticPlanner>(problem, seed, threads, std::make_unique<HandPartner>(problem, seed));
}

void expectSameRoadmap(const Planner& a, const Planner& b) {
  ASSERT_EQ(a.nodes().size(), b.nodes().size());
  for (std::size_t i = 0; i < a.nodes().size(); ++i) ASSERT_EQ(a.nodes()[i].q, b.nodes()[i].q) << i;
  EXPECT_EQ(a.edges().size(), b.edges().size());
  EXPECT_EQ(a.counts().queries.collision, b.counts().queries.collision);
  EXPECT_EQ(a.counts().queries.distance, b.counts().queries.distance);
}

TEST(Interactive, WithoutAHandOrWithOneAtRestItIsTheAutomaticPlannerBitByBit) {
  const Problem problem = closedProblem();
  for (const int slots : {1, 4}) {
    TestHost nobody(problem, 3000);
    TestHost also(problem, 3000);
    WalkingHand resting(problem, {}, 3000);
    for (ParameterValues* values : {&nobody.values, &also.values, &resting.values}) {
      ASSERT_TRUE(values->set(ParameterId::Slots, slots));
    }
    AutomaticPlanner automatic(problem, 1, 2);
    automatic.solve(nobody);
    const auto alone = interactive(problem, 1);
    alone->solve(also);
    expectSameRoadmap(automatic, *alone);
    const auto held = interactive(problem, 1);
    held->solve(resting);
    expectSameRoadmap(automatic, *held);
  }
}

TEST(Interactive, TheSameHandGivesTheSameRoadmapOnAnyNumberOfThreads) {
  const Problem problem = bentTunnel();
  const auto run = [&](std::size_t threads) {
    WalkingHand hand(problem, kThroughTheTunnel, 20'000);
    auto planner = interactive(problem, 3, threads);
    EXPECT_TRUE(planner->solve(hand));
    planner->completeRoadmap();
    return planner;
  };
  const auto one = run(1);
  const auto two = run(2);
  const auto four = run(4);
  expectSameRoadmap(*one, *two);
  expectSameRoadmap(*one, *four);
  EXPECT_EQ(one->path()->configurations(), four->path()->configurations());
  EXPECT_EQ(*handReportOf(*one), *handReportOf(*four));
}

TEST(Interactive, AHandThatShowsTheWayNeedsAFractionOfTheSteps) {
  const Problem problem = bentTunnel();
  std::uint64_t alone = 0;
  std::uint64_t shown = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    TestHost nobody(problem, 60'000);
    AutomaticPlanner automatic(problem, seed, 2);
    automatic.solve(nobody);
    alone += automatic.counts().steps;
    WalkingHand hand(problem, kThroughTheTunnel, 60'000);
    const auto planner = interactive(problem, seed);
    ASSERT_TRUE(planner->solve(hand)) << "seed " << seed;
    shown += planner->counts().steps;
    const auto report = handReportOf(*planner);
    ASSERT_TRUE(report);
    EXPECT_GT(report->shown, 10U);
    EXPECT_GT(report->followed, 0.1);
  }
  EXPECT_LT(5 * shown, alone);
}

/// Some thousands of steps pass for each shown configuration, as on a machine at full speed.
TEST(Interactive, AHandThatMisleadsCostsATenthOfTheWork) {
  const Problem problem = closedProblem();
  WalkingHand hand(problem, kElsewhere, 200'000, 3.5e-6);
  auto partner = std::make_unique<HandPartner>(problem, 1);
  const HandAccount& account = partner->account();
  AutomaticPlanner planner(problem, 1, 2, std::move(partner));
  EXPECT_FALSE(planner.solve(hand));
  EXPECT_GT(handReportOf(planner)->shown, 20U);
  EXPECT_GT(account.work().hand, 0U);
  const HandAccount::Work& work = account.work();
  EXPECT_LT(static_cast<double>(work.hand), 0.1 * static_cast<double>(work.all));
}

/// Draws one configuration that no hand shows.
class Nowhere final : public ConfigurationSampler {
 public:
  static Pose pose() { return Pose::translation({100.0, 0.0, 0.0}); }
  Pose draw(const Box3& /*tree*/) override { return pose(); }
};

/// Number of draws, of a thousand by a sliding member, that are not its own, after a run with a hand at full speed.
int drawnAboutTheHand(const Problem& problem, std::vector<Vector3> points) {
  WalkingHand hand(problem, std::move(points), 200'000, 3.5e-6);
  auto partner = std::make_unique<HandPartner>(problem, 1);
  const HandPartner& ofPlanner = *partner;
  AutomaticPlanner planner(problem, 1, 2, std::move(partner));
  EXPECT_FALSE(planner.solve(hand));
  const auto sampler = ofPlanner.sampler(std::make_unique<Nowhere>(), 1, true);
  int drawn = 0;
  for (int i = 0; i < 1000; ++i) drawn += sampler->draw(problem.bounds) == Nowhere::pose() ? 0 : 1;
  return drawn;
}

TEST(Interactive, MembersThatSlideDrawHalfAboutAHandInContact) {
  Problem problem = closedProblem();
  EXPECT_LT(drawnAboutTheHand(problem, kElsewhere), 350);
  problem.start = Pose::translation({-0.305, 0.0, 0.0});  // 5 mm before the wall
  EXPECT_NEAR(drawnAboutTheHand(problem, {{-0.305, 1.0, 0.0}, {-0.305, -1.0, 0.0}}), 500, 60);
}

/// A path along the hand's way counts as the hand's if it was found by a member that draws there.
TEST(Interactive, SaysWhoJoinedStartAndGoal) {
  const Problem problem = closedProblem();
  WalkingHand hand(problem, kElsewhere, 2'000);
  auto owned = std::make_unique<HandPartner>(problem, 1);
  HandPartner& partner = *owned;
  AutomaticPlanner planner(problem, 1, 2, std::move(owned));
  EXPECT_FALSE(planner.solve(hand));
  Path along;
  Path elsewhere;
  for (int i = 0; i <= 10; ++i) {
    along.points.push_back({interpolate(problem.start, Pose::translation(kElsewhere[0]), i / 10.0), Author::Computer});
    elsewhere.points.push_back({Pose::translation({2.0, 0.0, 0.1 * i}), Author::Computer});
  }
  const auto joined = [&](const Path& path, bool shared) {
    partner.solved(path, shared);
    return handReportOf(planner)->joined;
  };
  EXPECT_TRUE(joined(along, true));
  EXPECT_FALSE(joined(along, false));
  EXPECT_FALSE(joined(elsewhere, true));
}

TEST(Interactive, SaysWhatTheHandHasShown) {
  const Problem problem = bentTunnel();
  // The points lie beside the channel: in the wall by less than the object can be moved back.
  WalkingHand hand(problem, {{-1.8, 0.06, 0.04}, {0.03, 0.06, 0.04}, {0, 1.05, 0.04}, {1.8, 1.05, 0.04}}, 20'000);
  const auto planner = interactive(problem, 1);
  ASSERT_TRUE(planner->solve(hand));
  const auto report = handReportOf(*planner);
  ASSERT_TRUE(report);
  EXPECT_GT(report->movedToContact, 5U);
  EXPECT_LE(report->movedToContact, report->collided);
  EXPECT_LE(report->collided, report->shown);
}

}  // namespace
}  // namespace glissade
