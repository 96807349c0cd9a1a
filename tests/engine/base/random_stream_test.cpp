#include "engine/base/random_stream.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glissade {
namespace {

TEST(RandomStream, SameSeedAndNameGiveTheSameNumbers) {
  RandomStream a(42, "shooter");
  RandomStream b(42, "shooter");
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.bits(), b.bits());
}

TEST(RandomStream, NumbersArePinnedAcrossMachines) {
  RandomStream stream(1, "golden");
  EXPECT_EQ(stream.bits(), 15680886806208828396ULL);
}

TEST(RandomStream, NamesSeparateStreams) {
  EXPECT_NE(RandomStream(42, "shooter").bits(), RandomStream(42, "authority").bits());
}

TEST(RandomStream, MomentsAreThoseOfTheDistributions) {
  RandomStream stream(7, "moments");
  constexpr int kCount = 200000;
  double uniformSum = 0;
  double normalSum = 0;
  double normalSquares = 0;
  double exponentialSum = 0;
  for (int i = 0; i < kCount; ++i) {
    const double u = stream.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    uniformSum += u;
    const double n = stream.normal();
    normalSum += n;
    normalSquares += n * n;
    exponentialSum += stream.exponential(4.0);
  }
  EXPECT_NEAR(uniformSum / kCount, 0.5, 0.005);
  EXPECT_NEAR(normalSum / kCount, 0.0, 0.01);
  EXPECT_NEAR(normalSquares / kCount, 1.0, 0.02);
  EXPECT_NEAR(exponentialSum / kCount, 0.25, 0.005);
}

}  // namespace
}  // namespace glissade
