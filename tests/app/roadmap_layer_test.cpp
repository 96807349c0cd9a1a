#include "widgets/scene3d/roadmap_layer.h"

#include <gtest/gtest.h>
#include <osg/BlendColor>

namespace glissade {
namespace {

/// A run whose tree is a chain of so many edges.
SessionSnapshot chain(std::uint64_t run, std::uint32_t edges) {
  SessionSnapshot snapshot;
  snapshot.run = run;
  auto chunk = std::make_shared<RoadmapChunk>();
  chunk->nodes.resize(edges + 1);
  for (std::uint32_t i = 0; i < edges; ++i) chunk->edges.push_back({i, i + 1});
  snapshot.roadmap.push_back(chunk);
  return snapshot;
}

/// 1 where lines cover what is behind them.
float opacityOf(const RoadmapLayer& layer) {
  const auto* blend =
      dynamic_cast<const osg::BlendColor*>(layer.node()->getStateSet()->getAttribute(osg::StateAttribute::BLENDCOLOR));
  return blend == nullptr ? 1.0F : blend->getConstantColor().a();
}

TEST(RoadmapLayer, LargeTreesFadeAndSmallOnesDoNot) {
  RoadmapLayer layer;
  layer.update(chain(1, 1000));
  EXPECT_EQ(layer.segments(), 1000U);
  EXPECT_EQ(opacityOf(layer), 1.0F);
  layer.update(chain(2, 8000));
  EXPECT_FLOAT_EQ(opacityOf(layer), 0.5F);
  layer.update(chain(3, 500000));
  EXPECT_FLOAT_EQ(opacityOf(layer), 0.03F);
  layer.clear();
  EXPECT_EQ(opacityOf(layer), 1.0F);
}

TEST(RoadmapLayer, UploadsWhatIsNewOnly) {
  RoadmapLayer layer;
  SessionSnapshot snapshot = chain(1, 1000);
  layer.update(snapshot);
  const std::size_t uploads = layer.uploads();
  layer.update(snapshot);
  EXPECT_EQ(layer.uploads(), uploads);
}

}  // namespace
}  // namespace glissade
