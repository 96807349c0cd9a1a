#include "engine/planning/automatic/portfolio.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

TEST(Luby, IsTheSequenceOfThePaper) {
  const std::vector<std::uint64_t> expected{1, 1, 2, 1, 1, 2, 4, 1, 1, 2, 1, 1, 2, 4, 8, 1};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(lubyTerm(i + 1), expected[i]) << "term " << i + 1;
}

TEST(Portfolio, DealsWorkByShareWhateverATurnCosts) {
  Portfolio portfolio({{1.0}, {3.0}});
  for (int turn = 0; turn < 1000; ++turn) {
    const std::size_t who = portfolio.next();
    portfolio.charge(who, who == 0 ? 50 : 7);
  }
  EXPECT_NEAR(static_cast<double>(portfolio.work(1)) / static_cast<double>(portfolio.work(0)), 3.0, 0.1);
}

TEST(Portfolio, LivesFollowTheRestartSchedule) {
  Portfolio portfolio({{1.0, 10, Restart::Luby}, {1.0, 10, Restart::Doubling}, {1.0, 0, Restart::Never}});
  const auto lifeLength = [&](std::size_t who) {
    std::uint64_t length = 0;
    for (; !portfolio.lifeIsOver(who) && length < 1000; ++length) portfolio.charge(who, 1);
    portfolio.restart(who);
    return length;
  };
  for (const std::uint64_t expected : {10U, 10U, 20U, 10U, 10U, 20U, 40U}) EXPECT_EQ(lifeLength(0), expected);
  for (const std::uint64_t expected : {10U, 20U, 40U, 80U}) EXPECT_EQ(lifeLength(1), expected);
  EXPECT_EQ(lifeLength(2), 1000U);
}

TEST(Portfolio, ALateOneEntersAfterItsWorkAndDoesNotCatchUp) {
  Portfolio portfolio({{1.0}, {1.0, 0, Restart::Never, 100}});
  for (int turn = 0; turn < 100; ++turn) {
    ASSERT_EQ(portfolio.next(), 0U);
    portfolio.charge(0, 1);
  }
  for (int turn = 0; turn < 100; ++turn) portfolio.charge(portfolio.next(), 1);
  EXPECT_EQ(portfolio.work(0), 150U);
  EXPECT_EQ(portfolio.work(1), 50U);
}

TEST(Portfolio, TheRetiredHaveNoTurnsAndALateOneNeedNotWaitForThem) {
  Portfolio portfolio({{1.0}, {1.0, 0, Restart::Never, 100}});
  portfolio.retire(0);
  EXPECT_EQ(portfolio.next(), 1U);
  portfolio.retire(1);
  EXPECT_EQ(portfolio.next(), Portfolio::kNobody);
}

TEST(Portfolio, WhatEarnsGetsMore) {
  Portfolio portfolio({{1.0}, {1.0}});
  for (int turn = 0; turn < 300; ++turn) {
    const std::size_t who = portfolio.next();
    portfolio.charge(who, 10);
    if (who == 1) portfolio.reward(who, 10);
  }
  EXPECT_NEAR(static_cast<double>(portfolio.work(1)) / static_cast<double>(portfolio.work(0)), 2.0, 0.1);
}

}  // namespace
}  // namespace glissade
