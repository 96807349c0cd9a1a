#include "widgets/scene3d/detail_node.h"

#include <osgUtil/CullVisitor>

#include <algorithm>
#include <cmath>
#include <utility>

namespace glissade {
namespace {

/// A coarser child is drawn if its error is within this share of the tolerance.
constexpr double kClearlyBetter = 0.75;
/// Edges that cover more than this share of the faces fade to cover this share.
constexpr double kMostCovered = 0.15;
/// Edges with less than this share of their opacity are not drawn.
constexpr double kLeastOpacity = 0.4;

/// Device pixels per metre at the point of the sphere that is nearest to the eye; infinite if the eye is inside.
double pixelsPerMetreAt(osgUtil::CullVisitor& visitor, const osg::BoundingSphere& sphere) {
  const osg::Matrixd& projection = *visitor.getProjectionMatrix();
  const double atDistanceOne = 0.5 * visitor.getViewport()->height() * projection(1, 1);
  const bool isOrthographic = projection(3, 3) != 0.0;
  if (isOrthographic) return atDistanceOne;
  const double distance = (visitor.getEyeLocal() - sphere.center()).length() - sphere.radius();
  return distance > 0.0 ? atDistanceOne / distance : HUGE_VAL;
}

}  // namespace

void DetailNode::addDetail(osg::Node* child, double error) {
  errors_.push_back(error);
  addChild(child);
}

void DetailNode::addLater(const std::shared_ptr<LateDetails>& details, std::function<void(const ShapeDetail&)> add) {
  late_ = details;
  add_ = std::move(add);
}

void DetailNode::addMade() {
  const std::vector<ShapeDetail>* made = late_->get();
  if (made == nullptr) return;
  for (const ShapeDetail& detail : *made) add_(detail);
  late_.reset();
}

/// The bound of the first child, which nearly contains the other ones: all show the same body.
osg::BoundingSphere DetailNode::computeBound() const {
  return getNumChildren() == 0 ? osg::BoundingSphere() : getChild(0)->getBound();
}

void DetailNode::traverse(osg::NodeVisitor& visitor) {
  osgUtil::CullVisitor* cull = visitor.asCullVisitor();
  if (cull == nullptr) {
    osg::Group::traverse(visitor);
    return;
  }
  if (errors_.empty()) return;
  const double pixelsPerMetre = pixelsPerMetreAt(*cull, measured_.value_or(getBound()));
  const double tolerance = cull->getLODScale();
  if (tolerance > 0.0 && late_) addMade();
  drawn_ = std::clamp(drawn_, coarsestWithin(kClearlyBetter * tolerance, pixelsPerMetre),
                      coarsestWithin(tolerance, pixelsPerMetre));
  if (prepare(drawn_, pixelsPerMetre)) getChild(drawn_)->accept(visitor);
}

bool DetailNode::prepare(unsigned /*detail*/, double /*pixelsPerMetre*/) { return true; }

unsigned DetailNode::coarsestWithin(double tolerance, double pixelsPerMetre) const {
  if (tolerance <= 0.0) return 0;
  unsigned coarsest = 0;
  for (unsigned i = 1; i < errors_.size() && errors_[i] * pixelsPerMetre <= tolerance; ++i) coarsest = i;
  return coarsest;
}

FadingEdges::FadingEdges(const osg::ref_ptr<osg::Vec4Array>& colour, double width)
    : colour_(colour), opacity_(colour_->front().a()), width_(width) {}

void FadingEdges::addEdges(osg::Node* lines, double error, double density) {
  densities_.push_back(density);
  addDetail(lines, error);
}

bool FadingEdges::prepare(unsigned detail, double pixelsPerMetre) {
  const double covered = width_ * densities_[detail] / pixelsPerMetre;
  const double share = covered > kMostCovered ? kMostCovered / covered : 1.0;
  colour_->front().a() = opacity_ * static_cast<float>(share);
  return share >= kLeastOpacity;
}

}  // namespace glissade
