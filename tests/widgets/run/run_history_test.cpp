#include "widgets/run/run_history.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

RunSample at(double seconds) { return {seconds, 10.0 * seconds, 0.5, {}}; }

TEST(RunHistory, ALongRunIsThinnedAndEndsWithTheLatestSample) {
  RunHistory history;
  constexpr int kCount = 10000;
  for (int i = 0; i < kCount; ++i) {
    history.add(1, at(0.1 * i));
    ASSERT_LE(history.samples().size(), RunHistory::kMost);
    ASSERT_DOUBLE_EQ(history.samples().back().seconds, 0.1 * i);
  }
  EXPECT_GT(history.samples().size(), RunHistory::kMost / 4);
  EXPECT_DOUBLE_EQ(history.samples().front().seconds, 0.0);
  for (std::size_t i = 1; i < history.samples().size(); ++i) {
    const double step = history.samples()[i].seconds - history.samples()[i - 1].seconds;
    EXPECT_GT(step, 0.0);
    EXPECT_LT(step, 0.1 * kCount * 4.0 / RunHistory::kMost);
  }
}

TEST(RunHistory, AnotherRunBeginsAnewAndAReplayGoesBack) {
  RunHistory history;
  for (const double seconds : {0.0, 1.0, 2.0, 3.0}) history.add(1, at(seconds));
  history.add(1, at(1.5));
  EXPECT_EQ(history.samples().size(), 3U);
  EXPECT_DOUBLE_EQ(history.samples().back().seconds, 1.5);
  history.add(1, at(1.5));
  EXPECT_EQ(history.samples().size(), 3U);
  history.add(2, at(0.0));
  EXPECT_EQ(history.samples().size(), 1U);
}

}  // namespace
}  // namespace glissade
