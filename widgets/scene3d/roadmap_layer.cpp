#include "widgets/scene3d/roadmap_layer.h"

#include <osg/LineWidth>
#include <osg/Point>

#include <algorithm>

#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

/// Vertices in a batch: uploads stay small, draw calls few.
constexpr int kBatch = 8192;

}  // namespace

RoadmapLayer::RoadmapLayer() : root_(new osg::Group), geode_(new osg::Geode), palette_(paletteOf(Theme::Light)) {
  root_->addChild(geode_);
  makeDrawing(*root_);
  setPalette(palette_);
}

void RoadmapLayer::setPalette(const ScenePalette& palette) {
  palette_ = palette;
  osg::StateSet* state = root_->getOrCreateStateSet();
  state->setAttributeAndModes(new osg::LineWidth(1.2F * palette.pixelScale));
  state->setAttributeAndModes(new osg::Point(4.0F * palette.pixelScale));
  const auto recolour = [&](std::size_t vertex, const osg::Vec4ub& colour) {
    (*lines_[vertex / kBatch].colours)[vertex % kBatch] = colour;
  };
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const osg::Vec4ub colour = colourOf(nodes_[std::max(edges_[i].from, edges_[i].to)], palette_);
    recolour(2 * i, colour);
    recolour(2 * i + 1, colour);
  }
  for (Batch& batch : lines_) batch.colours->dirty();
}

void RoadmapLayer::update(const SessionSnapshot& snapshot) {
  if (snapshot.run != run_) {
    clear();
    run_ = snapshot.run;
  }
  for (; chunksTaken_ < snapshot.roadmap.size(); ++chunksTaken_) take(*snapshot.roadmap[chunksTaken_]);
  for (; droppedTaken_ < snapshot.droppedEdges.size(); ++droppedTaken_) drop(snapshot.droppedEdges[droppedTaken_]);
}

void RoadmapLayer::clear() {
  geode_->removeDrawables(0, geode_->getNumDrawables());
  lines_.clear();
  points_.clear();
  nodes_.clear();
  edges_.clear();
  chunksTaken_ = 0;
  droppedTaken_ = 0;
  segmentsDrawn_ = 0;
}

void RoadmapLayer::take(const RoadmapChunk& chunk) {
  nodes_.insert(nodes_.end(), chunk.nodes.begin(), chunk.nodes.end());
  for (const RoadmapNode& node : chunk.nodes) {
    if (node.author != Author::Computer) addVertex(points_, GL_POINTS, node.q.position, colourOf(node, palette_));
  }
  for (const RoadmapEdge& edge : chunk.edges) {
    const osg::Vec4ub colour = colourOf(nodes_[std::max(edge.from, edge.to)], palette_);
    addVertex(lines_, GL_LINES, nodes_[edge.from].q.position, colour);
    addVertex(lines_, GL_LINES, nodes_[edge.to].q.position, colour);
    edges_.push_back(edge);
    ++segmentsDrawn_;
  }
}

/// A dropped edge shrinks to a point.
void RoadmapLayer::drop(const RoadmapEdge& edge) {
  const auto found = std::find_if(edges_.rbegin(), edges_.rend(), [&](const RoadmapEdge& drawn) {
    return drawn.from == edge.from && drawn.to == edge.to;
  });
  if (found == edges_.rend()) return;
  const auto vertex = 2 * static_cast<std::size_t>(std::distance(found, edges_.rend()) - 1);
  Batch& batch = lines_[vertex / kBatch];
  (*batch.vertices)[vertex % kBatch + 1] = (*batch.vertices)[vertex % kBatch];
  batch.vertices->dirty();
  --segmentsDrawn_;
}

void RoadmapLayer::addVertex(std::vector<Batch>& batches, GLenum mode, const Vector3& position,
                             const osg::Vec4ub& colour) {
  if (batches.empty() || batches.back().used == kBatch) batches.push_back(makeBatch(mode));
  Batch& batch = batches.back();
  (*batch.vertices)[static_cast<std::size_t>(batch.used)] = toOsg(position);
  (*batch.colours)[static_cast<std::size_t>(batch.used)] = colour;
  batch.range->setCount(++batch.used);
  batch.vertices->dirty();
  batch.colours->dirty();
  batch.geometry->dirtyBound();
  ++uploads_;
}

RoadmapLayer::Batch RoadmapLayer::makeBatch(GLenum mode) {
  Batch batch;
  batch.geometry = new osg::Geometry;
  batch.vertices = new osg::Vec3Array(kBatch);
  batch.colours = new osg::Vec4ubArray(kBatch);
  batch.colours->setNormalize(true);
  batch.range = new osg::DrawArrays(mode, 0, 0);
  batch.geometry->setVertexArray(batch.vertices);
  batch.geometry->setColorArray(batch.colours, osg::Array::BIND_PER_VERTEX);
  batch.geometry->addPrimitiveSet(batch.range);
  batch.geometry->setUseDisplayList(false);
  batch.geometry->setUseVertexBufferObjects(true);
  batch.geometry->setDataVariance(osg::Object::DYNAMIC);
  // The unused vertices lie at the origin: culling by their bound would be wrong.
  batch.geometry->setCullingActive(false);
  geode_->addDrawable(batch.geometry);
  return batch;
}

}  // namespace glissade
