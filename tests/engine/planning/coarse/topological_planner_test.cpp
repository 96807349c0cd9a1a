#include "engine/planning/coarse/topological_planner.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "engine/base/random_stream.h"

namespace glissade {
namespace {

constexpr double kClosed = std::numeric_limits<double>::infinity();

double stepCost(const TopologicalGraph& graph, int from, int to) {
  double least = kClosed;
  for (const auto& edge : graph.edges) {
    if (edge.from == from && edge.to == to) least = std::min(least, edge.cost);
  }
  return least + graph.nodes[static_cast<std::size_t>(to)].cost;
}

/// The least cost of all ways that visit no node twice.
double bruteForce(const TopologicalGraph& graph, int at, std::set<int>& visited) {
  if (at == TopologicalGraph::kGoal) return 0.0;
  double least = kClosed;
  for (int to = 0; to < static_cast<int>(graph.nodes.size()); ++to) {
    const double cost = stepCost(graph, at, to);
    if (cost == kClosed || !visited.insert(to).second) continue;
    least = std::min(least, cost + bruteForce(graph, to, visited));
    visited.erase(to);
  }
  return least;
}

TopologicalGraph randomGraph(RandomStream& stream) {
  TopologicalGraph graph;
  const int count = 2 + static_cast<int>(stream.uniform(0, 6));
  for (int i = 0; i < count; ++i) {
    const double cost = i < 2 ? 0.0 : std::floor(stream.uniform(0, 4));
    graph.nodes.push_back({i - 2, Vector3::Zero(), stream.uniform() < 0.1 ? kClosed : cost});
  }
  graph.nodes[0].cost = graph.nodes[1].cost = 0.0;
  const double density = stream.uniform(0.1, 0.9);
  for (int from = 0; from < count; ++from) {
    for (int to = 0; to < count; ++to) {
      if (from == to) continue;
      for (int parallel = 0; parallel < 2; ++parallel) {
        if (stream.uniform() > density) continue;
        const double cost = stream.uniform() < 0.1 ? kClosed : std::floor(stream.uniform(0, 6));
        graph.edges.push_back({from, to, parallel, 1.0, cost});
      }
    }
  }
  return graph;
}

TEST(CheapestPath, CostsWhatTheBestOfAllPathsCosts) {
  RandomStream stream(17, "graphs");
  int without = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const TopologicalGraph graph = randomGraph(stream);
    std::set<int> visited{TopologicalGraph::kStart};
    const double least = bruteForce(graph, TopologicalGraph::kStart, visited);
    const std::vector<int> path = cheapestPath(graph);
    if (least == kClosed) {
      EXPECT_TRUE(path.empty()) << "trial " << trial;
      ++without;
      continue;
    }
    ASSERT_GE(path.size(), 2U) << "trial " << trial;
    EXPECT_EQ(path.front(), TopologicalGraph::kStart);
    EXPECT_EQ(path.back(), TopologicalGraph::kGoal);
    double cost = 0.0;
    double byEdges = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      cost += stepCost(graph, path[i - 1], path[i]);
      byEdges += edgeBetween(graph, path[i - 1], path[i]).cost + graph.nodes[static_cast<std::size_t>(path[i])].cost;
    }
    EXPECT_EQ(cost, least) << "trial " << trial;
    EXPECT_EQ(byEdges, least) << "trial " << trial;
  }
  EXPECT_GT(without, 50);
  EXPECT_LT(without, 1950);
}

}  // namespace
}  // namespace glissade
