#include "widgets/scene3d/roadmap_layer.h"

#include <osg/BlendColor>
#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/LineWidth>
#include <osg/Point>

#include <algorithm>

#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

/// Vertices in a batch: uploads stay small, draw calls few.
constexpr int kBatch = 8192;
/// Larger trees fade, or nothing else could be seen for them.
constexpr double kOpaqueSegments = 4000.0;
constexpr double kLeastOpacity = 0.03;
/// What is left of the roadmap once the path is the picture.
constexpr double kFadedShare = 0.12;

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
  if (snapshot.run != run_ || !isPrefixOf(snapshot)) {
    clear();
    run_ = snapshot.run;
  }
  // The last chunk taken may have been cut, and be longer now: only those before it are done with.
  for (; chunksTaken_ < snapshot.roadmap.size(); ++chunksTaken_) {
    const RoadmapChunk& chunk = *snapshot.roadmap[chunksTaken_];
    while (nodes_.size() < nodesBefore_ + chunk.nodes.size()) takeNode(chunk.nodes[nodes_.size() - nodesBefore_]);
    while (edges_.size() < edgesBefore_ + chunk.edges.size()) takeEdge(chunk.edges[edges_.size() - edgesBefore_]);
    if (chunksTaken_ + 1 == snapshot.roadmap.size()) break;
    nodesBefore_ += chunk.nodes.size();
    edgesBefore_ += chunk.edges.size();
  }
  for (; droppedTaken_ < snapshot.droppedEdges.size(); ++droppedTaken_) drop(snapshot.droppedEdges[droppedTaken_]);
  fade();
}

/// Lines of one opacity, blended by a constant colour: their own colours need not be uploaded again. While faded they
/// do not hide each other.
void RoadmapLayer::fade() {
  const double share = kOpaqueSegments / std::max<double>(1.0, static_cast<double>(segmentsDrawn_));
  const double faded = faded_ ? kFadedShare : 1.0;
  const auto opacity = static_cast<float>(faded * std::clamp(share, kLeastOpacity, 1.0));
  if (opacity == opacity_) return;
  opacity_ = opacity;
  osg::StateSet* state = root_->getOrCreateStateSet();
  if (opacity == 1.0F) {
    for (const auto type :
         {osg::StateAttribute::BLENDFUNC, osg::StateAttribute::BLENDCOLOR, osg::StateAttribute::DEPTH}) {
      state->removeAttribute(type);
    }
    return;
  }
  state->setAttributeAndModes(
      new osg::BlendFunc(osg::BlendFunc::CONSTANT_ALPHA, osg::BlendFunc::ONE_MINUS_CONSTANT_ALPHA));
  state->setAttributeAndModes(new osg::BlendColor(osg::Vec4(1.0F, 1.0F, 1.0F, opacity)));
  state->setAttributeAndModes(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, false));
}

void RoadmapLayer::setFaded(bool faded) {
  faded_ = faded;
  fade();
}

void RoadmapLayer::clear() {
  geode_->removeDrawables(0, geode_->getNumDrawables());
  lines_.clear();
  points_.clear();
  nodes_.clear();
  edges_.clear();
  chunksTaken_ = nodesBefore_ = edgesBefore_ = 0;
  droppedTaken_ = 0;
  segmentsDrawn_ = 0;
  fade();
}

/// What is drawn is the beginning of what is to be shown.
bool RoadmapLayer::isPrefixOf(const SessionSnapshot& snapshot) const {
  std::size_t nodes = 0;
  std::size_t edges = 0;
  for (const auto& chunk : snapshot.roadmap) {
    nodes += chunk->nodes.size();
    edges += chunk->edges.size();
  }
  return nodes >= nodes_.size() && edges >= edges_.size() && snapshot.droppedEdges.size() >= droppedTaken_;
}

void RoadmapLayer::takeNode(const RoadmapNode& node) {
  nodes_.push_back(node);
  if (node.author != Author::Computer) addVertex(points_, GL_POINTS, node.q.position, colourOf(node, palette_));
}

void RoadmapLayer::takeEdge(const RoadmapEdge& edge) {
  const osg::Vec4ub colour = colourOf(nodes_[std::max(edge.from, edge.to)], palette_);
  addVertex(lines_, GL_LINES, nodes_[edge.from].q.position, colour);
  addVertex(lines_, GL_LINES, nodes_[edge.to].q.position, colour);
  edges_.push_back(edge);
  ++segmentsDrawn_;
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
