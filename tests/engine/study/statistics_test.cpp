#include "engine/study/statistics.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

// Values of R: prop.test(x, n, correct = FALSE)$conf.int, which is Wilson's interval.
TEST(Wilson95, AgreesWithPublishedValues) {
  const Proportion half = wilson95(15, 30);
  EXPECT_DOUBLE_EQ(half.share, 0.5);
  EXPECT_NEAR(half.low, 0.33154, 1e-5);
  EXPECT_NEAR(half.high, 0.66846, 1e-5);
  const Proportion few = wilson95(1, 10);
  EXPECT_NEAR(few.low, 0.017876, 1e-6);
  EXPECT_NEAR(few.high, 0.404150, 1e-6);
}

TEST(Wilson95, StaysWithinZeroAndOne) {
  const Proportion none = wilson95(0, 10);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 0.277533, 1e-6);  // z^2 / (n + z^2)
  const Proportion all = wilson95(100, 100);
  EXPECT_EQ(all.high, 1.0);
  EXPECT_NEAR(all.low, 0.963007, 1e-6);
  const Proportion nothing = wilson95(0, 0);
  EXPECT_EQ(nothing.low, 0.0);
  EXPECT_EQ(nothing.high, 1.0);
}

TEST(Distribution, QuartilesInterpolate) {
  const Distribution four = distributionOf({4, 1, 3, 2});  // value of R: quantile(1:4)
  EXPECT_EQ(four.count, 4U);
  EXPECT_DOUBLE_EQ(four.minimum, 1.0);
  EXPECT_DOUBLE_EQ(four.firstQuartile, 1.75);
  EXPECT_DOUBLE_EQ(four.median, 2.5);
  EXPECT_DOUBLE_EQ(four.thirdQuartile, 3.25);
  EXPECT_DOUBLE_EQ(four.maximum, 4.0);
  EXPECT_DOUBLE_EQ(four.mean, 2.5);
  const Distribution five = distributionOf({10, 20, 30, 40, 1000});
  EXPECT_DOUBLE_EQ(five.firstQuartile, 20.0);
  EXPECT_DOUBLE_EQ(five.median, 30.0);
  EXPECT_DOUBLE_EQ(five.thirdQuartile, 40.0);
  EXPECT_DOUBLE_EQ(five.mean, 220.0);
}

TEST(Distribution, OfOneValueAndOfNone) {
  const Distribution one = distributionOf({7});
  EXPECT_DOUBLE_EQ(one.firstQuartile, 7.0);
  EXPECT_DOUBLE_EQ(one.median, 7.0);
  EXPECT_DOUBLE_EQ(one.thirdQuartile, 7.0);
  EXPECT_EQ(distributionOf({}).count, 0U);
}

TEST(Distribution, DoesNotDependOnTheOrderGiven) {
  const std::vector<double> sample{0.1, 1e17, 0.3, -1e17, 0.7};
  std::vector<double> reversed(sample.rbegin(), sample.rend());
  EXPECT_EQ(distributionOf(sample).mean, distributionOf(reversed).mean);
}

}  // namespace
}  // namespace glissade
