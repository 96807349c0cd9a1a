#include "engine/sequence/line_balance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

LineTasks randomTasks(RandomStream& stream, std::size_t count, double density) {
  LineTasks tasks;
  for (std::size_t i = 0; i < count; ++i) {
    tasks.seconds.push_back(std::floor(stream.uniform(1.0, 20.0)));
    tasks.before.emplace_back();
    for (std::size_t earlier = 0; earlier < i; ++earlier) {
      if (stream.uniform() < density) tasks.before.back().push_back(earlier);
    }
  }
  return tasks;
}

double cycleOf(const LineTasks& tasks, const std::vector<std::size_t>& stationOf, std::size_t stations) {
  std::vector<double> load(stations, 0.0);
  for (std::size_t i = 0; i < stationOf.size(); ++i) load[stationOf[i]] += tasks.seconds[i];
  return *std::max_element(load.begin(), load.end());
}

bool keepsOrder(const LineTasks& tasks, const std::vector<std::size_t>& stationOf) {
  for (std::size_t i = 0; i < stationOf.size(); ++i) {
    for (const std::size_t earlier : tasks.before[i]) {
      if (stationOf[earlier] > stationOf[i]) return false;
    }
  }
  return true;
}

/// Tries every division.
double shortestCycle(const LineTasks& tasks, std::size_t stations) {
  const std::size_t count = tasks.seconds.size();
  double shortest = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> stationOf(count, 0);
  for (;;) {
    if (keepsOrder(tasks, stationOf)) shortest = std::min(shortest, cycleOf(tasks, stationOf, stations));
    std::size_t i = 0;
    while (i < count && ++stationOf[i] == stations) stationOf[i++] = 0;
    if (i == count) return shortest;
  }
}

TEST(LineBalance, IsTheShortestOfAllDivisions) {
  RandomStream stream(5, "lines");
  for (int i = 0; i < 40; ++i) {
    const std::size_t stations = 2 + static_cast<std::size_t>(i) % 2;
    const LineTasks tasks = randomTasks(stream, 8, 0.25);
    const auto line = balanceLine(tasks, stations);
    ASSERT_TRUE(line);
    const double shortest = shortestCycle(tasks, stations);
    EXPECT_TRUE(keepsOrder(tasks, line->stationOf));
    EXPECT_DOUBLE_EQ(line->cycle, cycleOf(tasks, line->stationOf, stations));
    EXPECT_LE(line->least, shortest + 1e-6);
    EXPECT_LE(line->cycle, 1.005 * shortest + 1e-6) << i;
    EXPECT_LE(line->efficiency(), 1.0 + 1e-12);
  }
}

TEST(LineBalance, IsTheSameEachTime) {
  RandomStream stream(6, "lines");
  const LineTasks tasks = randomTasks(stream, 30, 0.1);
  const auto once = balanceLine(tasks, 4);
  const auto again = balanceLine(tasks, 4);
  ASSERT_TRUE(once && again);
  EXPECT_EQ(once->stationOf, again->stationOf);
}

/// The problem is larger than the limit of the integer program, so the order of the tasks is divided.
TEST(LineBalance, DividesManyTasks) {
  RandomStream stream(7, "lines");
  const LineTasks tasks = randomTasks(stream, 1000, 0.002);
  const auto line = balanceLine(tasks, 10);
  ASSERT_TRUE(line);
  EXPECT_TRUE(keepsOrder(tasks, line->stationOf));
  EXPECT_LE(line->cycle, line->least + 20.0);
}

TEST(LineBalance, OfNoTaskIsEmpty) {
  const auto line = balanceLine({}, 3);
  ASSERT_TRUE(line);
  EXPECT_EQ(line->cycle, 0.0);
  EXPECT_TRUE(longestChain({}).empty());
}

TEST(LineBalance, RefusesWhatIsNoLine) {
  const LineTasks tasks{{1.0, 2.0}, {{}, {0}}};
  EXPECT_EQ(toString(balanceLine(tasks, 0).error().location), "stations");
  EXPECT_EQ(toString(balanceLine(tasks, 51).error().location), "stations");
  EXPECT_EQ(toString(balanceLine({{1.0, -2.0}, {{}, {0}}}, 2).error().location), "seconds");
  EXPECT_EQ(toString(balanceLine({{1.0, 2.0}, {{1}, {}}}, 2).error().location), "before");
  EXPECT_EQ(toString(balanceLine({{1.0, 2.0}, {{}, {1}}}, 2).error().location), "before");
}

TEST(LongestChain, TakesLongest) {
  const LineTasks tasks{{5.0, 1.0, 1.0, 9.0, 2.0}, {{}, {}, {0, 1}, {1}, {2}}};
  EXPECT_EQ(longestChain(tasks), (std::vector<std::size_t>{1, 3}));
}

TEST(LineTasks, AreTheStepsBackwards) {
  AssemblyPlan plan;
  plan.steps.resize(3);
  plan.steps[2].after = {1, 2};
  const LineTasks tasks = lineTasks(plan, {1.0, 2.0, 3.0});
  EXPECT_EQ(tasks.seconds, (std::vector<double>{3.0, 2.0, 1.0}));
  EXPECT_EQ(tasks.before[1], std::vector<std::size_t>{0});
  EXPECT_EQ(tasks.before[2], std::vector<std::size_t>{0});
  EXPECT_TRUE(tasks.before[0].empty());
}

}  // namespace
}  // namespace glissade
