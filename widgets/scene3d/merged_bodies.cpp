#include "widgets/scene3d/merged_bodies.h"

#include <osg/Geode>
#include <osg/PolygonOffset>
#include <osgUtil/CullVisitor>

#include <algorithm>
#include <utility>

#include "widgets/scene3d/detail_node.h"
#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {
namespace {

const MergeableBody* mergeableOf(const osg::Node& body) {
  return static_cast<const MergeableBody*>(body.getUserData());
}

osg::ref_ptr<osg::Geode> geodeOf(const osg::ref_ptr<osg::Geometry>& geometry) {
  osg::ref_ptr<osg::Geode> geode = new osg::Geode;
  geode->addDrawable(geometry);
  return geode;
}

/// Joins the arrays of several bodies, in the frame of the group.
class Joiner {
 public:
  Joiner() {
    shape_.corners = new osg::Vec3Array;
    shape_.normals = new osg::Vec3Array;
    shape_.edges = new osg::Vec3Array;
  }

  void add(const MergeableBody& body, const osg::Matrix& X_WB) {
    const osg::Vec4 colour = body.colour->front();
    osg::BoundingBox box;
    for (const osg::Vec3& corner : *body.shape.corners) {
      shape_.corners->push_back(corner * X_WB);
      box.expandBy(shape_.corners->back());
    }
    box_.expandBy(box);
    largest_ = std::max(largest_, box.radius());
    for (const osg::Vec3& normal : *body.shape.normals) {
      shape_.normals->push_back(osg::Matrix::transform3x3(normal, X_WB));
    }
    colours_->insert(colours_->end(), body.shape.corners->size(), colour);
    if (!body.edgeColour) return;
    for (const osg::Vec3& end : *body.shape.edges) shape_.edges->push_back(end * X_WB);
    edgeColour_ = *body.edgeColour;
    edgeWidth_ = body.edgeWidth;
  }

  /// Surface and edges in the form of makeBody().
  osg::ref_ptr<osg::Group> drawing() const {
    osg::ref_ptr<osg::Group> drawing = new osg::Group;
    osg::ref_ptr<osg::Geometry> surface = makeSurface(shape_, osg::Vec4());
    surface->setColorArray(colours_, osg::Array::BIND_PER_VERTEX);
    surface->getOrCreateStateSet()->setAttributeAndModes(new osg::PolygonOffset(1.0F, 1.0F));
    drawing->addChild(geodeOf(surface));
    if (shape_.edges->empty()) return drawing;
    osg::ref_ptr<osg::Vec4Array> colour = new osg::Vec4Array(1, &edgeColour_);
    osg::ref_ptr<osg::Geometry> lines = makeLines(shape_.edges, LineKind::Segments, edgeColour_, edgeWidth_);
    lines->setColorArray(colour, osg::Array::BIND_OVERALL);
    osg::ref_ptr<FadingEdges> edges = new FadingEdges(colour, edgeWidth_);
    edges->addEdges(geodeOf(lines), 0.0, edgeDensity(shape_));
    edges->measureAt({box_.center(), largest_});  // they fade as edges of a body in the middle
    drawing->addChild(edges);
    return drawing;
  }

 private:
  ShapeDetail shape_;
  osg::ref_ptr<osg::Vec4Array> colours_ = new osg::Vec4Array;
  osg::Vec4 edgeColour_;
  float edgeWidth_ = 0.0F;
  osg::BoundingBox box_;
  float largest_ = 0.0F;  ///< radius of the largest body
};

}  // namespace

void MergedBodies::traverse(osg::NodeVisitor& visitor) {
  const bool isHeadset = visitor.asCullVisitor() != nullptr && (visitor.getTraversalMask() & kWindowOnly) == 0U;
  if (!isHeadset) {
    osg::Group::traverse(visitor);
    return;
  }
  if (!isDivided_) divide();
  for (osg::Node* body : single_) body->accept(visitor);
  mayMerge_ = true;
  for (Cell& cell : cells_) {
    look(cell);
    if (cell.merged) {
      cell.merged->accept(visitor);
    } else {
      for (osg::MatrixTransform* body : cell.bodies) body->accept(visitor);
    }
  }
}

void MergedBodies::releaseGLObjects(osg::State* state) const {
  osg::Group::releaseGLObjects(state);
  for (const Cell& cell : cells_) {
    if (cell.merged) cell.merged->releaseGLObjects(state);
  }
}

void MergedBodies::resizeGLObjectBuffers(unsigned size) {
  osg::Group::resizeGLObjectBuffers(size);
  for (const Cell& cell : cells_) {
    if (cell.merged) cell.merged->resizeGLObjectBuffers(size);
  }
}

bool MergedBodies::setChild(unsigned place, osg::Node* body) {
  isDivided_ = false;
  return osg::Group::setChild(place, body);
}

void MergedBodies::childInserted(unsigned /*place*/) { isDivided_ = false; }

void MergedBodies::childRemoved(unsigned /*place*/, unsigned /*number*/) { isDivided_ = false; }

void MergedBodies::divide() {
  isDivided_ = true;
  single_.clear();
  cells_.clear();
  std::vector<osg::MatrixTransform*> mergeable;
  for (const osg::ref_ptr<osg::Node>& child : _children) {
    if (mergeableOf(*child) != nullptr) {
      mergeable.push_back(static_cast<osg::MatrixTransform*>(child.get()));
    } else {
      single_.push_back(child.get());
    }
  }
  if (mergeable.size() < kFewest) {
    single_.insert(single_.end(), mergeable.begin(), mergeable.end());
  } else {
    divide(std::move(mergeable));
  }
}

/// Divides the bodies along the longest side of the box of their origins, so that the bodies of a cell are near each
/// other.
void MergedBodies::divide(std::vector<osg::MatrixTransform*> bodies) {
  if (bodies.size() <= kTogether) {
    Cell cell;
    cell.seen.resize(bodies.size());
    cell.bodies = std::move(bodies);
    cells_.push_back(std::move(cell));
    return;
  }
  osg::BoundingBoxd box;
  for (const osg::MatrixTransform* body : bodies) box.expandBy(body->getMatrix().getTrans());
  const osg::Vec3d sides = box._max - box._min;
  int axis = sides.y() > sides.x() ? 1 : 0;
  if (sides.z() > sides[axis]) axis = 2;
  const auto middle = bodies.begin() + static_cast<std::ptrdiff_t>(bodies.size() / 2);
  std::nth_element(bodies.begin(), middle, bodies.end(), [axis](const auto* a, const auto* b) {
    return a->getMatrix().getTrans()[axis] < b->getMatrix().getTrans()[axis];
  });
  divide({bodies.begin(), middle});
  divide({middle, bodies.end()});
}

/// Compares the bodies with the last picture. A change is drawn at once, because a changed cell is not merged any more.
void MergedBodies::look(Cell& cell) {
  bool isStill = true;
  for (std::size_t i = 0; i < cell.bodies.size(); ++i) {
    const osg::MatrixTransform& body = *cell.bodies[i];
    const Seen now{body.getMatrix(), mergeableOf(body)->colour->front(), body.getNodeMask()};
    if (now == cell.seen[i]) continue;
    cell.seen[i] = now;
    isStill = false;
  }
  if (!isStill) {
    cell.stillFor = 0;
    cell.merged = nullptr;
  } else if (!cell.merged && ++cell.stillFor >= kStill && std::exchange(mayMerge_, false)) {
    cell.merged = merge(cell);
  }
}

osg::ref_ptr<osg::Group> MergedBodies::merge(const Cell& cell) {
  Joiner joiner;
  for (const osg::MatrixTransform* body : cell.bodies) {
    if (body->getNodeMask() != 0U) joiner.add(*mergeableOf(*body), body->getMatrix());
  }
  return joiner.drawing();
}

}  // namespace glissade
