#include "engine/operator/simulated_operator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/operator/operator_support.h"

namespace glissade {
namespace {

constexpr double kTick = 1.0 / 40.0;
const Se3Metric kMetric(1.536);

std::vector<Pose> route() {
  Pose turned = Pose::translation({2, 1, 0});
  turned.orientation = fromRollPitchYaw(0.5, 0.2, 1.0);
  return {Pose::translation({1, 0, 0}), turned, Pose::translation({-1, 2, 1})};
}

SimulatedOperator make(const char* level, std::uint64_t seed = 1) {
  return {*findOperatorLevel(level), route(), kMetric, seed};
}

TEST(SimulatedOperator, ReachesTheEndOfHisRouteWhenTheTreeFollows) {
  for (const char* level : {"expert", "default", "novice"}) {
    SimulatedOperator person = make(level);
    Pose q;
    double nearest = 1e9;
    // The tree is where the operator is: it has reached a way point when the operator has.
    const auto treeAtHand = [&q](const Pose& wanted) { return kMetric.distance(q, wanted); };
    for (int i = 0; i < 60 * 40; ++i) {
      q = person.advance(kTick, viewOf(q, treeAtHand), kRoom);
      if (person.target() == 2) nearest = std::min(nearest, kMetric.distance(q, route().back()));
    }
    EXPECT_EQ(person.target(), 2U) << level;
    EXPECT_LT(nearest, 0.3) << level;
  }
}

TEST(SimulatedOperator, WaitsForATreeThatLagsAndThenGoesBackForIt) {
  SimulatedOperator person = make("expert");
  Pose q;
  double lag = 0.0;
  const auto tree = [&](const Pose&) { return lag; };
  for (int i = 0; i < 200; ++i) q = person.advance(kTick, viewOf(q, tree), kRoom);
  const std::size_t reached = person.target();
  EXPECT_EQ(reached, 2U);
  lag = 2.0;
  const Pose before = q;
  for (int i = 0; i < 2 * 40; ++i) q = person.advance(kTick, viewOf(q, tree), kRoom);
  EXPECT_LT((q.position - before.position).norm(), 0.1) << "he waits, but for his tremor";
  for (int i = 0; i < 3 * 40; ++i) q = person.advance(kTick, viewOf(q, tree), kRoom);
  EXPECT_LT(person.target(), reached);
}

/// The target after ten seconds with a tree that comes only into the neighbourhood of the way points, at a given
/// clearance.
std::size_t targetAfterTenSeconds(bool slides, double clearance) {
  SimulatedOperator person = make("expert");
  Pose q;
  OperatorView view = viewOf(q, 0.7);
  view.clearance = [clearance] { return clearance; };
  for (int i = 0; i < 400; ++i) {
    view.q_device = q;
    view.contactNodes += slides ? 1 : 0;
    q = person.advance(kTick, view, kRoom);
  }
  return person.target();
}

TEST(SimulatedOperator, LosesPatienceWithATreeThatIsNearUnlessItSlides) {
  EXPECT_GT(targetAfterTenSeconds(false, 0.1), 0U);
  EXPECT_EQ(targetAfterTenSeconds(true, 0.1), 0U);
}

TEST(SimulatedOperator, ATreeThatSlidesComesAsNearAsTheSurfaceBelowHisHand) {
  EXPECT_GT(targetAfterTenSeconds(true, 0.5), 0U);
}

TEST(SimulatedOperator, KeepsToHisSpeed) {
  for (const OperatorLevel& level : operatorLevels()) {
    SimulatedOperator person(level, route(), kMetric, 3);
    Pose q;
    for (int i = 0; i < 2000; ++i) {
      const Pose next = person.advance(kTick, viewOf(q, 10.0 * (i % 200 == 199 ? 0.0 : 0.01)), kRoom);
      // Tremor is added to the speed; ten of its standard deviations are beyond chance.
      EXPECT_LE((next.position - q.position).norm(), level.linearSpeed * kTick + 10 * level.tremor);
      q = next;
    }
  }
}

TEST(SimulatedOperator, TremorHasItsStationaryDeviation) {
  const OperatorLevel& level = *findOperatorLevel("novice");
  SimulatedOperator person(level, {Pose::identity()}, kMetric, 5);
  Pose q;
  double lag = 10.0;  // the operator waits, so that only tremor moves the hand (there is no way point before target 0)
  double squares = 0.0;
  constexpr int kTicks = 100;
  Vector3 previous = q.position;
  double steps = 0.0;
  for (int i = 0; i < kTicks; ++i) {
    q = person.advance(kTick, viewOf(q, lag), kRoom);
    squares += q.position.squaredNorm();
    steps += (q.position - previous).norm();
    previous = q.position;
  }
  EXPECT_GT(steps, 0.0);
  EXPECT_GT(std::sqrt(squares / kTicks), 0.3 * level.tremor);
  EXPECT_LT(std::sqrt(squares / kTicks), 2.5 * level.tremor);
}

TEST(SimulatedOperator, SeedsDiffer) {
  SimulatedOperator a = make("expert", 1);
  SimulatedOperator b = make("expert", 2);
  EXPECT_NE(a.advance(kTick, viewOf(Pose::identity(), 10.0), kRoom),
            b.advance(kTick, viewOf(Pose::identity(), 10.0), kRoom));
}

}  // namespace
}  // namespace glissade
