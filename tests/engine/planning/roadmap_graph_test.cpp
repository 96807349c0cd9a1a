#include "engine/planning/roadmap_graph.h"

#include <gtest/gtest.h>

namespace glissade {
namespace {

RoadmapNode at(double x, TreeSide side = TreeSide::Start) {
  return {Pose::translation({x, 0, 0}), Author::Computer, side};
}

class RoadmapGraphTest : public testing::Test {
 protected:
  // start - a - b        goal - c
  RoadmapGraph graph{Se3Metric(1.0)};
  RoadmapGraph::Node start = graph.addRoot(at(0));
  RoadmapGraph::Node goal = graph.addRoot(at(10, TreeSide::Goal));
  RoadmapGraph::Node a = graph.addChild(start, at(1));
  RoadmapGraph::Node b = graph.addChild(a, at(2));
  RoadmapGraph::Node c = graph.addChild(goal, at(8, TreeSide::Goal));
};

TEST_F(RoadmapGraphTest, NodesBelongToTheirRootsComponent) {
  EXPECT_TRUE(graph.connected(start, b));
  EXPECT_TRUE(graph.connected(goal, c));
  EXPECT_FALSE(graph.connected(start, goal));
  EXPECT_FALSE(graph.way(start, goal));
  EXPECT_EQ(graph.components().size(), 2U);
  EXPECT_EQ(graph.directedEdgeCount(), 2 * graph.nodes().size() - 4);
}

TEST_F(RoadmapGraphTest, JoiningTwoTreesGivesThePapersEdgeCount) {
  graph.join(c, b);
  EXPECT_TRUE(graph.connected(start, goal));
  EXPECT_EQ(graph.components().size(), 1U);
  EXPECT_EQ(graph.componentOf(goal), graph.componentOf(start));
  EXPECT_EQ(graph.directedEdgeCount(), 2 * graph.nodes().size() - 2);
  const auto way = graph.way(start, goal);
  ASSERT_TRUE(way);
  EXPECT_EQ(way->nodes, (std::vector<RoadmapGraph::Node>{start, a, b, c, goal}));
  EXPECT_EQ(way->edges.size(), 4U);
}

TEST_F(RoadmapGraphTest, ADroppedEdgeSplitsItsComponentAndNeighboursFollow) {
  graph.join(b, c);
  const auto way = graph.way(start, goal);
  graph.dropEdge(way->edges[1]);  // a - b
  EXPECT_TRUE(graph.connected(start, a));
  EXPECT_FALSE(graph.connected(start, goal));
  EXPECT_TRUE(graph.connected(b, goal));
  EXPECT_EQ(graph.components().size(), 2U);
  EXPECT_EQ(graph.directedEdgeCount(), 2 * graph.nodes().size() - 4);
  EXPECT_EQ(graph.nearest(graph.componentOf(start), Pose::translation({9, 0, 0})).index, a);
  EXPECT_EQ(graph.nearest(graph.componentOf(b), Pose::translation({0, 0, 0})).index, b);
  graph.join(a, b);
  EXPECT_TRUE(graph.way(start, goal));
}

}  // namespace
}  // namespace glissade
