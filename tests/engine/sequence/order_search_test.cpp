#include "engine/sequence/order_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

/// Random precedence without circles, and random costs of a step after another one.
OrderQuestion randomQuestion(RandomStream& random, std::size_t steps) {
  OrderQuestion question;
  std::vector<std::vector<double>> costs(steps + 1, std::vector<double>(steps));
  for (auto& row : costs) {
    for (double& cost : row) cost = std::floor(random.uniform(0.0, 4.0));
  }
  for (std::size_t step = 0; step < steps; ++step) {
    question.after.emplace_back();
    for (std::size_t earlier = 0; earlier < step; ++earlier) {
      if (random.uniform() < 0.15) question.after.back().push_back(earlier);
    }
  }
  question.cost = [costs, steps](std::size_t step, const std::size_t* last, const std::vector<bool>&) {
    return costs[last == nullptr ? steps : *last][step];
  };
  return question;
}

bool keeps(const std::vector<std::size_t>& order, const OrderQuestion& question) {
  std::vector<bool> done(order.size(), false);
  for (const std::size_t step : order) {
    for (const std::size_t earlier : question.after[step]) {
      if (!done[earlier]) return false;
    }
    done[step] = true;
  }
  return true;
}

double least(const OrderQuestion& question) {
  std::vector<std::size_t> order(question.after.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  double cost = std::numeric_limits<double>::infinity();
  do {
    if (keeps(order, question)) cost = std::min(cost, costOf(order, question));
  } while (std::next_permutation(order.begin(), order.end()));
  return cost;
}

/// All states can be expanded, so the order is optimal.
TEST(OrderSearch, FindsTheCheapestOrderThatKeepsWhatComesBefore) {
  RandomStream random(1, "orders");
  for (int round = 0; round < 40; ++round) {
    OrderQuestion question = randomQuestion(random, 7);
    question.mostExpansions = 100'000;
    const auto order = cheapestOrder(question, {});
    ASSERT_EQ(order.size(), 7U);
    EXPECT_TRUE(keeps(order, question));
    EXPECT_DOUBLE_EQ(costOf(order, question), least(question));
  }
}

TEST(OrderSearch, HasAnOrderHoweverFewStatesItExpands) {
  RandomStream random(2, "orders");
  for (std::size_t expansions : {0U, 1U, 50U, 2000U}) {
    OrderQuestion question = randomQuestion(random, 40);
    question.mostExpansions = expansions;
    const auto order = cheapestOrder(question, {});
    ASSERT_EQ(order.size(), 40U);
    EXPECT_TRUE(keeps(order, question));
    question.mostExpansions = 0;
    EXPECT_LE(costOf(order, question), costOf(cheapestOrder(question, {}), question));
  }
  EXPECT_TRUE(cheapestOrder({}, {}).empty());
}

/// Steps of two kinds, where each change costs. Only one state is expanded, and moved runs join steps of one kind.
TEST(OrderSearch, MovesRunsOfStepsToWhereTheyCostLess) {
  constexpr std::size_t kSteps = 10;
  OrderQuestion question;
  question.mostExpansions = 1;
  question.after.resize(kSteps);
  question.cost = [](std::size_t step, const std::size_t* last, const std::vector<bool>& done) {
    const auto carriedOut = static_cast<std::size_t>(std::count(done.begin(), done.end(), true));
    const double early = carriedOut < 4 && step != carriedOut ? 2.0 : 0.0;  // misleads the first order
    return early + (last != nullptr && step % 2 != *last % 2 ? 5.0 : 0.0);
  };
  const auto order = cheapestOrder(question, {});
  EXPECT_LE(costOf(order, question), 11.0) << "of one change, or of none in the first four";
  EXPECT_TRUE(keeps(order, question));
}

/// Steps 0 and 3 count as one where they follow each other, and so do 1 and 4. Step 2 is to be number 3.
TEST(OrderSearch, KeepsTheNumberOfAStepAsItIsCounted) {
  OrderQuestion question;
  question.after.resize(5);
  question.continues = [](std::size_t step, std::size_t before) { return step == before + 3; };
  question.cost = [&](std::size_t step, const std::size_t* last, const std::vector<bool>&) {
    return last != nullptr && question.continues(step, *last) ? 0.0 : 1.0;
  };
  question.numbers = {0, 0, 3, 0, 0};
  const std::vector<std::size_t> order = cheapestOrder(question, {});
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 3, 1, 4, 2})) << "after two of them, and not after two steps";
  question.numbers = {0, 0, 1, 0, 0};
  EXPECT_EQ(cheapestOrder(question, {}), (std::vector<std::size_t>{2, 0, 3, 1, 4}));
}

}  // namespace
}  // namespace glissade
