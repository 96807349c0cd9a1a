#include "engine/sequence/blocking_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

/// Edges of bodies, with the number of edges that were queried.
struct KnownGraph {
  explicit KnownGraph(std::size_t count) : blockers(count), stays(count, false), candidates(count) {
    std::iota(candidates.begin(), candidates.end(), 0);
  }

  std::vector<BodyGroup> groups(const std::vector<BodyGroup>& units, std::size_t most) const {
    const BlockingGraph::Edges edges{
        [&](std::size_t /*blocked*/) -> const std::vector<std::size_t>& { return candidates; },
        [&](std::size_t blocker, std::size_t blocked) {
          asked.emplace(blocker, blocked);
          return blockers[blocked].count(blocker) != 0;
        }};
    return BlockingGraph(stays, edges).groups(units, most);
  }

  std::vector<std::set<std::size_t>> blockers;
  BodySet stays;
  std::vector<std::size_t> candidates;
  mutable std::set<std::pair<std::size_t, std::size_t>> asked;
};

/// A random graph of `count` bodies, some of which stay, in units of one or two.
struct RandomGraph : KnownGraph {
  RandomGraph(RandomStream& random, std::size_t count) : KnownGraph(count) {
    for (std::size_t body = 0; body < count; ++body) {
      stays[body] = random.uniform() < 0.15;
      for (std::size_t other = 0; other < count; ++other) {
        if (other == body || random.uniform() > 0.2) continue;
        blockers[body].insert(other);
      }
    }
    units.push_back({0, 1});
    for (std::size_t body = 2; body < count; ++body) units.push_back({body});
  }

  /// True if the mask contains whole units and no body that stays, and no body outside blocks it.
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

  std::vector<BodyGroup> units;
};

unsigned maskOf(const BodyGroup& group) {
  unsigned mask = 0;
  for (const std::size_t body : group) mask |= 1U << body;
  return mask;
}

/// Compares with all subsets.
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
    for (const BodyGroup& group : random_graph.groups(random_graph.units, kBodies)) groups.insert(maskOf(group));
    EXPECT_EQ(groups, expected);
    found += static_cast<int>(groups.size());
  }
  EXPECT_GT(found, 20);
}

TEST(BlockingGraph, KeepsToTheLargestSize) {
  KnownGraph graph(3);
  graph.blockers[0] = {1};
  graph.blockers[1] = {2};
  const std::vector<BodyGroup> units{{0}, {1}, {2}};
  EXPECT_EQ(graph.groups(units, 3).size(), 2U);
  EXPECT_EQ(graph.groups(units, 2), (std::vector<BodyGroup>{{1, 2}}));
}

/// A row of bodies, each blocked by the next one, before one that stays.
TEST(BlockingGraph, AsksNothingMoreOfWhatCannotLeave) {
  constexpr std::size_t kBodies = 40;
  KnownGraph graph(kBodies);
  std::vector<BodyGroup> units;
  for (std::size_t body = 0; body < kBodies; ++body) {
    units.push_back({body});
    for (std::size_t other = 0; other < body; ++other) graph.blockers[body].insert(other);
  }
  graph.stays[0] = true;
  EXPECT_TRUE(graph.groups(units, 32).empty());
  EXPECT_LE(graph.asked.size(), kBodies);
}

TEST(BlockingGraph, ChoosesTheSmallestGroupsThatHaveNoBodyInCommon) {
  const auto volume = [](const BodyGroup& group) { return static_cast<double>(group.back()); };
  const auto chosen = smallestDisjoint({{0, 1, 2}, {2, 3}, {4, 5}, {3, 4}, {2, 3}, {0, 1, 9}}, volume);
  EXPECT_EQ(chosen, (std::vector<BodyGroup>{{2, 3}, {4, 5}, {0, 1, 9}}));
}

}  // namespace
}  // namespace glissade
