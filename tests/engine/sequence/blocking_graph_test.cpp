#include "engine/sequence/blocking_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

/// A random graph of `count` bodies, some of which stay, in units of one or two.
struct RandomGraph {
  RandomGraph(RandomStream& random, std::size_t count) : graph(count), blockers(count), stays(count) {
    for (std::size_t body = 0; body < count; ++body) {
      stays[body] = random.uniform() < 0.15;
      if (stays[body]) graph.stays(body);
      for (std::size_t other = 0; other < count; ++other) {
        if (other == body || random.uniform() > 0.2) continue;
        blockers[body].insert(other);
        graph.blocks(other, body);
      }
    }
    units.push_back({0, 1});
    for (std::size_t body = 2; body < count; ++body) units.push_back({body});
  }

  /// Whole units, nobody stays, nobody outside blocks.
  bool leaves(unsigned mask) const {
    const auto has = [&](std::size_t body) { return (mask >> body & 1U) != 0; };
    if (has(0) != has(1)) return false;
    for (std::size_t body = 0; body < blockers.size(); ++body) {
      if (!has(body)) continue;
      if (stays[body]) return false;
      if (!std::all_of(blockers[body].begin(), blockers[body].end(), has)) return false;
    }
    return true;
  }

  BlockingGraph graph;
  std::vector<std::set<std::size_t>> blockers;
  std::vector<bool> stays;
  std::vector<BodyGroup> units;
};

unsigned maskOf(const BodyGroup& group) {
  unsigned mask = 0;
  for (const std::size_t body : group) mask |= 1U << body;
  return mask;
}

/// Against all subsets.
TEST(BlockingGraph, FindsTheSmallestGroupWithEachUnit) {
  constexpr std::size_t kBodies = 8;
  RandomStream random(1, "graphs");
  int found = 0;
  for (int round = 0; round < 200; ++round) {
    const RandomGraph random_graph(random, kBodies);
    std::set<unsigned> expected;
    for (const BodyGroup& unit : random_graph.units) {
      unsigned least = 0;
      for (unsigned mask = 1; mask < 1U << kBodies; ++mask) {
        if ((mask & maskOf(unit)) != maskOf(unit) || !random_graph.leaves(mask)) continue;
        if (least == 0 || (mask & least) == mask) least = mask;
      }
      if (least != 0 && least != maskOf(unit)) expected.insert(least);
    }
    std::set<unsigned> groups;
    for (const BodyGroup& group : random_graph.graph.groups(random_graph.units, kBodies)) groups.insert(maskOf(group));
    EXPECT_EQ(groups, expected);
    found += static_cast<int>(groups.size());
  }
  EXPECT_GT(found, 20);
}

TEST(BlockingGraph, KeepsToTheLargestSize) {
  BlockingGraph graph(3);
  graph.blocks(1, 0);
  graph.blocks(2, 1);
  const std::vector<BodyGroup> units{{0}, {1}, {2}};
  EXPECT_EQ(graph.groups(units, 3).size(), 2U);
  EXPECT_EQ(graph.groups(units, 2), (std::vector<BodyGroup>{{1, 2}}));
}

TEST(BlockingGraph, ChoosesTheSmallestGroupsThatHaveNoBodyInCommon) {
  const auto volume = [](const BodyGroup& group) { return static_cast<double>(group.back()); };
  const auto chosen = smallestDisjoint({{0, 1, 2}, {2, 3}, {4, 5}, {3, 4}, {2, 3}, {0, 1, 9}}, volume);
  EXPECT_EQ(chosen, (std::vector<BodyGroup>{{2, 3}, {4, 5}, {0, 1, 9}}));
}

}  // namespace
}  // namespace glissade
