#include "engine/operator/head/head_tracking.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace glissade {
namespace {

constexpr double kPeriod = 1.0 / 60.0;

/// Sends the same reading for a time, and returns the time after it.
double hold(HeadTracking& head, const HeadReading& reading, double time, double seconds) {
  for (const double end = time + seconds; time < end; time += kPeriod) head.take(reading, time);
  return time;
}

TEST(OneEuroFilter, IsBehindARampByItsDelay) {
  OneEuroFilter filter;
  filter.setShape({0.1, 0.0});
  filter.reset(0.0);
  double smoothed = 0.0;
  double time = 0.0;
  constexpr double kStep = 1e-3;
  for (int i = 1; i <= 5000; ++i) {
    time = i * kStep;
    smoothed = filter.smooth(0.2 * time, kStep);
  }
  EXPECT_NEAR(filter.delay(), 0.1, 1e-9);
  EXPECT_NEAR((0.2 * time - smoothed) / 0.2, filter.delay(), 0.01);
}

TEST(OneEuroFilter, LagsLessWhereTheValueMovesFast) {
  OneEuroFilter filter;
  filter.setShape({0.1, 20.0});
  filter.reset(0.0);
  for (int i = 1; i <= 300; ++i) filter.smooth(0.5 * i * kPeriod, kPeriod);
  EXPECT_LT(filter.delay(), 0.03);
}

/// With noise of a millimetre, less than half of it remains at rest.
TEST(HeadTracking, AHeadAtRestDoesNotTremble) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 1e-3);
  HeadTracking head;
  head.setShaping({});
  double time = hold(head, {}, 0.0, 1.0);
  double squared = 0.0;
  for (int i = 0; i < 600; ++i, time += kPeriod) {
    head.take({noise(random)}, time);
    squared += head.motion().shift.squaredNorm();
  }
  EXPECT_LT(std::sqrt(squared / 600.0), 0.5e-3);
}

TEST(HeadTracking, AxesAndSignsAreSet) {
  HeadTracking head;
  HeadShaping shaping;
  shaping.axes = {{{2, true}, {1}, {0}, {4}, {3, true}, {5}}};
  head.setShaping(shaping);
  hold(head, {0.1, 0.2, 0.3, 0.4, 0.0, 0.0}, 0.0, 5.0);
  const HeadMotion motion = head.motion();
  EXPECT_LT((motion.shift - Vector3(-0.3, 0.2, 0.1)).norm(), 1e-3);
  const Quaternion pitched(Eigen::AngleAxisd(-0.4, Vector3::UnitX()));
  EXPECT_LT(motion.turn.angularDistance(pitched), 1e-3);
}

TEST(HeadTracking, RestIsWhereThePersonSaysSo) {
  HeadTracking head;
  head.setShaping({});
  const double time = hold(head, {0.1, -0.2, 0.7, 0.1, 0.1, 0.1}, 0.0, 3.0);
  head.restHere();
  hold(head, head.last(), time, 5.0);
  EXPECT_LT(head.motion().shift.norm(), 1e-3);
  EXPECT_LT(head.motion().turn.angularDistance(Quaternion::Identity()), 1e-3);
}

TEST(HeadTracking, ASilentTrackerLetsTheViewGoBackSlowlyAndToItsRest) {
  HeadTracking head;
  head.setShaping({});
  double time = hold(head, {0.2}, 0.0, 3.0);
  const double before = head.motion().shift.x();
  head.passTime(time + 0.9 * HeadTracking::kSilence);
  EXPECT_EQ(head.motion().shift.x(), before) << "nothing moves before it is lost";
  time += HeadTracking::kSilence;
  EXPECT_FALSE(head.isTracked(time));
  double largest = 0.0;
  for (int i = 0; i < 600 && !head.isAtRest(); ++i) {
    const double at = head.motion().shift.x();
    head.passTime(time += kPeriod);
    largest = std::max(largest, at - head.motion().shift.x());
  }
  EXPECT_TRUE(head.isAtRest());
  EXPECT_LT(largest, 0.05 * before);
}

/// The motion does not jump, even if the tracker's reading differs then.
TEST(HeadTracking, ATrackerThatComesBackMakesNoJump) {
  HeadTracking head;
  head.setShaping({});
  double time = hold(head, {0.2}, 0.0, 3.0) + 1.0;
  head.passTime(time);
  const double returned = head.motion().shift.x();
  head.take({-0.3}, time);
  EXPECT_NEAR(head.motion().shift.x(), returned, 0.02);
  hold(head, {-0.3}, time + kPeriod, 3.0);
  EXPECT_NEAR(head.motion().shift.x(), -0.3, 1e-3);
}

/// For any readings at any times, the motion is finite and within the limits of a head.
TEST(HeadTracking, RandomReadingsAtRandomTimesGiveAHeadNearTheScreen) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> reading(-10.0, 10.0);
  std::exponential_distribution<double> pause(20.0);
  HeadTracking head;
  head.setShaping({});
  double time = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    if (i % 7 == 0) head.passTime(time);
    head.take({reading(random), reading(random), reading(random), reading(random), 0.0, reading(random)}, time);
    ASSERT_LE(head.motion().shift.cwiseAbs().maxCoeff(), 10.0);
    ASSERT_NEAR(head.motion().turn.norm(), 1.0, 1e-9);
    if (i % 3 != 0) time += pause(random);
  }
}

TEST(HeadTracking, ShapingOutOfRangeIsTheStandard) {
  HeadShaping shaping;
  shaping.axes[1].source = 6;
  shaping.axes[2].source = -1;
  shaping.rest[0] = std::numeric_limits<double>::quiet_NaN();
  shaping.restDelay = 7.0;
  EXPECT_EQ(inRange(shaping), HeadShaping());
}

}  // namespace
}  // namespace glissade
