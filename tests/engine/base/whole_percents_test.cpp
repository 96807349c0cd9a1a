#include "engine/base/whole_percents.h"

#include <gtest/gtest.h>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

using Percents = std::array<int, 3>;

TEST(WholePercents, HaveTheSum100WhereEachAloneWouldBeRoundedUp) {
  EXPECT_EQ(wholePercents(std::array{0.335, 0.335, 0.33}), (Percents{34, 33, 33}));
  EXPECT_EQ(wholePercents(std::array{1.0, 1.0, 1.0}), (Percents{34, 33, 33}));
  EXPECT_EQ(wholePercents(std::array{0.0, 2.0, 0.0}), (Percents{0, 100, 0}));
  EXPECT_EQ(wholePercents(std::array{0.0, 0.0, 0.0}), (Percents{0, 0, 0}));
}

TEST(WholePercents, AreNoFartherThanOneFromTheirShares) {
  RandomStream stream(1, "percents");
  for (int i = 0; i < 1000; ++i) {
    const std::array shares{stream.uniform(0.0, 1.0), stream.uniform(0.0, 1.0), stream.uniform(0.0, 1.0)};
    const double sum = shares[0] + shares[1] + shares[2];
    const Percents percents = wholePercents(shares);
    EXPECT_EQ(percents[0] + percents[1] + percents[2], 100);
    for (std::size_t k = 0; k < shares.size(); ++k) EXPECT_NEAR(percents[k], 100.0 * shares[k] / sum, 1.0);
  }
}

}  // namespace
}  // namespace glissade
