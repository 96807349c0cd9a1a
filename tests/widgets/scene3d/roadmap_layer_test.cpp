#include "widgets/scene3d/roadmap_layer.h"

#include <gtest/gtest.h>
#include <osg/Stencil>

#include <algorithm>
#include <cmath>

#include "engine/geometry/primitives.h"
#include "widgets/scene3d/body_layer.h"

namespace glissade {
namespace {

/// A run whose tree goes to and fro in a square of a metre, with edges of a metre.
SessionSnapshot chain(std::uint64_t run, std::uint32_t edges) {
  SessionSnapshot snapshot;
  snapshot.run = run;
  auto chunk = std::make_shared<RoadmapChunk>();
  chunk->nodes.resize(edges + 1);
  for (std::uint32_t i = 0; i < edges; ++i) chunk->edges.push_back({i, i + 1});
  for (std::uint32_t i = 0; i <= edges; ++i) {
    chunk->nodes[i].q.position = {static_cast<double>(i % 2), static_cast<double>(i / 2 % 2), 0.0};
  }
  snapshot.roadmap.push_back(chunk);
  return snapshot;
}

/// Share of the scene that is visible behind this number of evenly spread lines or points.
double seenBehind(const std::vector<float>& opacities, std::uint32_t count, double coveredByOne) {
  const double inABatch = static_cast<double>(count) / static_cast<double>(opacities.size());
  double seen = 1.0;
  for (const float opacity : opacities) seen *= std::pow(1.0 - coveredByOne, opacity * inABatch);
  return seen;
}

TEST(RoadmapLayer, TheSceneIsSeenThroughTreesOfAnySize) {
  constexpr double kPixelsPerMetre = 500.0;
  constexpr double kCoveredByAnEdge = 1.2 / kPixelsPerMetre;
  for (const std::uint32_t edges : {1000U, 8000U, 100000U, 500000U}) {
    RoadmapLayer layer;
    layer.setScale(kPixelsPerMetre);
    layer.update(chain(1, edges));
    EXPECT_EQ(layer.segments(), edges);
    EXPECT_GT(seenBehind(layer.opacities(), edges, kCoveredByAnEdge), 0.5) << edges;
    EXPECT_GT(layer.opacities().back(), 0.0F) << "what is new is seen";
  }
}

TEST(RoadmapLayer, TheSceneIsSeenThroughPointsOfAnyNumber) {
  constexpr double kPixelsPerMetre = 500.0;
  constexpr double kCoveredByAPoint = 16.0 / (kPixelsPerMetre * kPixelsPerMetre);
  for (const std::uint32_t edges : {8000U, 100000U, 500000U}) {
    SessionSnapshot snapshot = chain(1, edges);
    auto chunk = std::make_shared<RoadmapChunk>(*snapshot.roadmap.front());
    for (RoadmapNode& node : chunk->nodes) node.author = Author::Contact;
    snapshot.roadmap.front() = chunk;
    RoadmapLayer layer;
    layer.setScale(kPixelsPerMetre);
    layer.update(snapshot);
    EXPECT_GT(seenBehind(layer.pointOpacities(), edges, kCoveredByAPoint), 0.5) << edges;
    EXPECT_GT(layer.pointOpacities().back(), 0.0F) << "what is new is seen";
  }
}

/// A run whose tree fills a square of a metre with edges of 0.01 m.
SessionSnapshot fineChain(std::uint32_t edges) {
  SessionSnapshot snapshot = chain(1, edges);
  auto chunk = std::make_shared<RoadmapChunk>(*snapshot.roadmap.front());
  for (std::uint32_t i = 0; i <= edges; ++i) {
    const std::uint32_t row = i / 100;
    const std::uint32_t column = row % 2 == 0 ? i % 100 : 99 - i % 100;
    chunk->nodes[i].q.position = {0.01 * column, 0.01 * (row % 100), 0.0};
  }
  snapshot.roadmap.front() = chunk;
  return snapshot;
}

/// A batch of short edges covers little of the scene, but many batches could cover all of it.
TEST(RoadmapLayer, TheSceneIsSeenThroughTreesOfShortEdges) {
  constexpr double kPixelsPerMetre = 500.0;
  for (std::uint32_t edges = 4000; edges < 2000000; edges *= 3) {
    RoadmapLayer layer;
    layer.setScale(kPixelsPerMetre);
    layer.update(fineChain(edges));
    EXPECT_GT(seenBehind(layer.opacities(), edges, 0.01 * 1.2 / kPixelsPerMetre), 0.5) << edges;
  }
}

/// A node far away makes the box of a tree large, but the tree no thinner.
TEST(RoadmapLayer, TheSceneIsSeenThroughATreeWithANodeFarAway) {
  constexpr std::uint32_t kEdges = 100000;
  SessionSnapshot snapshot = chain(1, kEdges);
  auto chunk = std::make_shared<RoadmapChunk>(*snapshot.roadmap.front());
  chunk->nodes.back().q.position = {0.0, 20.0, 20.0};
  chunk->edges.pop_back();
  snapshot.roadmap.front() = chunk;
  RoadmapLayer layer;
  layer.setScale(500.0);
  layer.update(snapshot);
  EXPECT_GT(seenBehind(layer.opacities(), kEdges, 1.2 / 500.0), 0.5);
}

TEST(RoadmapLayer, OlderLinesAreFainterAndFewAreNot) {
  RoadmapLayer layer;
  layer.setScale(500.0);
  layer.update(chain(1, 100));
  EXPECT_EQ(layer.opacities(), std::vector<float>{1.0F});
  layer.update(chain(2, 20000));
  const std::vector<float> opacities = layer.opacities();
  ASSERT_GT(opacities.size(), 3U);
  EXPECT_TRUE(std::is_sorted(opacities.begin(), opacities.end()));
  EXPECT_LT(opacities.front(), opacities.back());
  layer.setScale(5e5);
  EXPECT_EQ(layer.opacities().front(), 1.0F) << "from near the lines are far from each other";
}

TEST(RoadmapLayer, SaysWhatIsDrawn) {
  RoadmapLayer layer;
  EXPECT_FALSE(layer.content().startTree);
  layer.update(chain(1, 10));
  EXPECT_TRUE(layer.content().startTree);
  EXPECT_FALSE(layer.content().contactNodes);
  layer.clear();
  EXPECT_FALSE(layer.content().startTree);
}

TEST(RoadmapLayer, UploadsWhatIsNewOnly) {
  RoadmapLayer layer;
  SessionSnapshot snapshot = chain(1, 1000);
  layer.update(snapshot);
  const std::size_t uploads = layer.uploads();
  layer.update(snapshot);
  EXPECT_EQ(layer.uploads(), uploads);
}

const osg::Stencil* stencilOf(const osg::Node& node) {
  const osg::StateSet* state = node.getStateSet();
  return state == nullptr ? nullptr
                          : static_cast<const osg::Stencil*>(state->getAttribute(osg::StateAttribute::STENCIL));
}

TEST(RoadmapLayer, ItsNodesDoNotHideTheObject) {
  const RoadmapLayer layer;
  BodyShapes shapes;
  const auto cube = std::make_shared<const TriangleMesh>(makeBox({1.0, 1.0, 1.0}));
  const ScenePalette palette = paletteOf(Theme::Light);
  const auto object = makeMovedBody(shapes.of(cube), Pose(), osg::Vec4(1.0F, 1.0F, 1.0F, 1.0F), palette);
  const osg::Stencil* marks = stencilOf(*object);
  const osg::Stencil* avoids = stencilOf(*layer.node());
  ASSERT_TRUE(marks != nullptr && avoids != nullptr);
  EXPECT_EQ(marks->getStencilPassAndDepthPassOperation(), osg::Stencil::REPLACE);
  EXPECT_EQ(avoids->getFunction(), osg::Stencil::NOTEQUAL);
  EXPECT_EQ(avoids->getFunctionRef(), marks->getFunctionRef());
  const double rim = object->getChild(object->getNumChildren() - 1)->getBound().radius();
  EXPECT_GT(rim, 1.2 * object->getChild(0)->getBound().radius()) << "the rim around it is marked, too";
}

}  // namespace
}  // namespace glissade
