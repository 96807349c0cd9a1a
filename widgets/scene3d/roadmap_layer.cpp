#include "widgets/scene3d/roadmap_layer.h"

#include <osg/BlendColor>
#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/LineWidth>
#include <osg/Point>

#include <algorithm>
#include <limits>

#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

/// Vertices of a batch, for small uploads and few draw calls.
constexpr int kBatch = 8192;
constexpr float kLineWidth = 1.2F;
constexpr float kPointSize = 4.0F;
/// Lines that would cover more of their area than this share fade, and so do points.
constexpr double kMostCovered = 0.5;
/// Opacity of a batch relative to the next younger one.
constexpr double kAgeing = 0.7;
/// Fainter lines cannot be distinguished from the background, and are not drawn.
constexpr double kFaintest = 0.02;
/// Opacity of the roadmap while a path is shown.
constexpr double kFadedShare = 0.12;

}  // namespace

RoadmapLayer::RoadmapLayer() : root_(new osg::Group), geode_(new osg::Geode), palette_(paletteOf(Theme::Light)) {
  root_->addChild(geode_);
  makeDrawing(*root_);
  makeAvoidMarks(*root_);
  setPalette(palette_);
}

void RoadmapLayer::setPalette(const ScenePalette& palette) {
  palette_ = palette;
  osg::StateSet* state = root_->getOrCreateStateSet();
  state->setAttributeAndModes(new osg::LineWidth(kLineWidth * palette.pixelScale));
  state->setAttributeAndModes(new osg::Point(kPointSize * palette.pixelScale));
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
  // The last chunk that was taken may have grown since; only the chunks before it are complete.
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

void RoadmapLayer::fade() {
  const double pixel = palette_.pixelScale;
  fade(lines_, [&](const Batch& batch) { return batch.length * pixelsPerMetre_ * kLineWidth * pixel; });
  fade(points_, [&](const Batch& batch) { return batch.used * kPointSize * kPointSize * pixel * pixel; });
}

/// Each batch has one opacity, blended by a constant colour, so that the colours of its vertices need not be uploaded
/// again.
void RoadmapLayer::fade(std::vector<Batch>& batches, const std::function<double(const Batch&)>& pixelsOf) {
  const double area = pixelsOfTrees();
  double covered = 0.0;
  double coveredAged = 0.0;
  double age = 1.0;
  for (auto batch = batches.rbegin(); batch != batches.rend(); ++batch, age *= kAgeing) {
    const double share = pixelsOf(*batch) / area;
    covered += share;
    coveredAged += age * share;
  }
  const bool ages = covered > kMostCovered;
  double opacity = faded_ ? kFadedShare : 1.0;
  if (ages) opacity *= std::min(1.0, kMostCovered / coveredAged);
  bool newest = true;
  for (auto batch = batches.rbegin(); batch != batches.rend(); ++batch) {
    const double shown = newest ? std::max(kFaintest, opacity) : opacity;
    setOpacity(*batch, shown < kFaintest ? 0.0F : static_cast<float>(shown));
    if (ages) opacity *= kAgeing;
    newest = false;
  }
}

/// The area in which most nodes are, measured by the spread of the nodes. Their box would be misleading, because nodes
/// crowd in some places, and a few are far away. Infinite while the scale of the picture is not known.
double RoadmapLayer::pixelsOfTrees() const {
  if (pixelsPerMetre_ <= 0.0 || nodes_.empty()) return std::numeric_limits<double>::infinity();
  const double count = static_cast<double>(nodes_.size());
  const Vector3 mean = sum_ / count;
  const Vector3 variance = (sumOfSquares_ / count - mean.cwiseAbs2()).cwiseMax(0.0);
  // An evenly filled box has the sides sqrt(12 variance).
  Vector3 sides = (12.0 * variance).cwiseSqrt().cwiseMin(box_.diagonal()) * pixelsPerMetre_;
  std::sort(sides.data(), sides.data() + 3);
  const double least = kPointSize * palette_.pixelScale;
  return std::max(least, sides[1]) * std::max(least, sides[2]);
}

/// Faded lines do not hide each other.
void RoadmapLayer::setOpacity(Batch& batch, float opacity) {
  if (opacity == batch.opacity) return;
  batch.opacity = opacity;
  batch.geometry->setNodeMask(opacity > 0.0F ? ~0U : 0U);
  osg::StateSet* state = batch.geometry->getOrCreateStateSet();
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

void RoadmapLayer::setScale(double pixelsPerMetre) {
  if (pixelsPerMetre == pixelsPerMetre_) return;
  pixelsPerMetre_ = pixelsPerMetre;
  fade();
}

std::vector<float> RoadmapLayer::opacitiesOf(const std::vector<Batch>& batches) {
  std::vector<float> opacities;
  for (const Batch& batch : batches) opacities.push_back(batch.opacity);
  return opacities;
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
  box_ = Box3();
  sum_ = sumOfSquares_ = Vector3::Zero();
  content_ = {};
}

/// Whether the drawn trees are the beginning of those in the snapshot.
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
  box_.extend(node.q.position);
  sum_ += node.q.position;
  sumOfSquares_ += node.q.position.cwiseAbs2();
  content_.operatorNodes |= node.author == Author::Operator;
  content_.contactNodes |= node.author == Author::Contact;
  if (node.author != Author::Computer) addVertex(points_, GL_POINTS, node.q.position, colourOf(node, palette_));
}

void RoadmapLayer::takeEdge(const RoadmapEdge& edge) {
  const RoadmapNode& later = nodes_[std::max(edge.from, edge.to)];
  const Vector3& from = nodes_[edge.from].q.position;
  const Vector3& to = nodes_[edge.to].q.position;
  addVertex(lines_, GL_LINES, from, colourOf(later, palette_));
  addVertex(lines_, GL_LINES, to, colourOf(later, palette_));
  lines_.back().length += (to - from).norm();
  content_.startTree |= later.side == TreeSide::Start;
  content_.goalTree |= later.side == TreeSide::Goal;
  edges_.push_back(edge);
  ++segmentsDrawn_;
}

/// Shrinks a dropped edge to a point.
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
  // Culling by the bound would be wrong, because unused vertices lie at the origin.
  batch.geometry->setCullingActive(false);
  geode_->addDrawable(batch.geometry);
  return batch;
}

}  // namespace glissade
