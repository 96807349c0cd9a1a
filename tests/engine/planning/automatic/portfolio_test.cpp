#include "engine/planning/automatic/portfolio.h"

#include <gtest/gtest.h>

#include <limits>

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

TEST(LifeLength, FollowsTheRestartSchedule) {
  const auto lengths = [](const Contender& contender) {
    std::vector<std::uint64_t> first;
    for (std::uint64_t life = 1; life <= 7; ++life) first.push_back(lifeLength(contender, life));
    return first;
  };
  EXPECT_EQ(lengths({1.0, 0, 10, Restart::Luby}), (std::vector<std::uint64_t>{10, 10, 20, 10, 10, 20, 40}));
  EXPECT_EQ(lengths({1.0, 0, 10, Restart::Doubling}), (std::vector<std::uint64_t>{10, 20, 40, 80, 160, 320, 640}));
  for (const Contender& endless : {Contender{1.0}, Contender{1.0, 0, 0, Restart::Luby}}) {
    EXPECT_EQ(lifeLength(endless, 1), std::numeric_limits<std::uint64_t>::max());
  }
}

TEST(Portfolio, ALateOneEntersAfterItsWorkAndDoesNotCatchUp) {
  Portfolio portfolio({{1.0}, {1.0, 0, 0, Restart::Never, 100}});
  for (int turn = 0; turn < 100; ++turn) {
    ASSERT_EQ(portfolio.next(), 0U);
    portfolio.charge(0, 1);
  }
  for (int turn = 0; turn < 100; ++turn) portfolio.charge(portfolio.next(), 1);
  EXPECT_EQ(portfolio.work(0), 150U);
  EXPECT_EQ(portfolio.work(1), 50U);
}

TEST(Portfolio, TheRetiredHaveNoTurnsAndALateOneNeedNotWaitForThem) {
  Portfolio portfolio({{1.0}, {1.0, 0, 0, Restart::Never, 100}});
  portfolio.retire(0);
  EXPECT_EQ(portfolio.next(), 1U);
  portfolio.retire(1);
  EXPECT_EQ(portfolio.next(), Portfolio::kNobody);
}

TEST(Portfolio, WhoHasOneLifeHasOneOfTheTurnsAtTheSameTime) {
  Portfolio portfolio({{1.0}, {2.0}, {1.0}, {1.0, 0, 0, Restart::Never, 1000}});
  portfolio.charge(0, 30);
  portfolio.charge(1, 40);  // 20 per unit of its doubled share
  portfolio.charge(2, 10);
  using Turns = std::vector<std::size_t>;
  EXPECT_EQ(portfolio.next(1, 10), Turns({2}));
  EXPECT_EQ(portfolio.next(2, 10), Turns({2, 1}));
  EXPECT_EQ(portfolio.next(8, 10), Turns({2, 1, 0}));  // no contender enters early
  portfolio.retire(1);
  EXPECT_EQ(portfolio.next(8, 10), Turns({2, 0}));
  portfolio.retire(0);
  portfolio.retire(2);
  EXPECT_EQ(portfolio.next(8, 10), Turns({3}));  // there is no other contender
  portfolio.retire(3);
  EXPECT_EQ(portfolio.next(8, 10), Turns());
}

TEST(Portfolio, SharesHoldForTurnsAtTheSameTimeToo) {
  Portfolio portfolio({{1.0, 0, 0, Restart::Luby}, {1.0}, {6.0, 0, 0, Restart::Luby}});
  for (int round = 0; round < 1000; ++round) {
    for (const std::size_t who : portfolio.next(4, 10)) portfolio.charge(who, 10);
  }
  EXPECT_NEAR(static_cast<double>(portfolio.work(2)), 30'000.0, 50.0);  // three of four slots in every round
  EXPECT_NEAR(static_cast<double>(portfolio.work(0)), 5'000.0, 50.0);
  EXPECT_NEAR(static_cast<double>(portfolio.work(1)), 5'000.0, 50.0);
}

TEST(Portfolio, PatienceUsedUpHalvesTheShareDownToALeast) {
  Portfolio portfolio({{2.0, 1000}, {2.0}});
  const auto ratioUntil = [&](std::uint64_t worth) {
    const std::uint64_t before[] = {portfolio.work(0), portfolio.work(1)};
    while (portfolio.work(0) < worth) portfolio.charge(portfolio.next(), 10);
    return static_cast<double>(portfolio.work(1) - before[1]) / static_cast<double>(portfolio.work(0) - before[0]);
  };
  EXPECT_NEAR(ratioUntil(1000), 1.0, 0.1);
  EXPECT_NEAR(ratioUntil(2000), 2.0, 0.1);
  EXPECT_NEAR(ratioUntil(4000), 4.0, 0.1);
  EXPECT_NEAR(ratioUntil(8000), 8.0, 0.1);
  EXPECT_NEAR(ratioUntil(16000), 8.0, 0.1);  // 8 instead of 16
  portfolio.reward(0);
  EXPECT_NEAR(ratioUntil(17000), 0.25, 0.1);
  EXPECT_NEAR(ratioUntil(18000), 0.5, 0.1);
}

TEST(Portfolio, OneOfEndlessPatienceKeepsItsShare) {
  Portfolio portfolio({{1.0, 0, 0, Restart::Luby}, {1.0}});
  for (int turn = 0; turn < 1000; ++turn) {
    const std::size_t who = portfolio.next();
    portfolio.charge(who, 10);
  }
  EXPECT_NEAR(static_cast<double>(portfolio.work(0)), static_cast<double>(portfolio.work(1)), 20.0);
}

}  // namespace
}  // namespace glissade
