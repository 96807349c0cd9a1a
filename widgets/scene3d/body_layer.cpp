#include "widgets/scene3d/body_layer.h"

#include <osg/PolygonOffset>

#include <algorithm>

#include "engine/environment/rigid_body.h"
#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

/// A ghost of more edges fades, or it would be a solid blob that hides what it stands beside.
constexpr double kPlainEdges = 400.0;
constexpr double kLeastShown = 0.03;
constexpr double kLeastFilled = 0.25;

struct Opacity {
  double surface;
  double edges;
};

Opacity opacityOf(BodyStyle style, std::size_t edges) {
  switch (style) {
    case BodyStyle::Solid: return {1.0, 1.0};
    case BodyStyle::SeeThrough: return {kObstacleOpacity, 1.0};
    case BodyStyle::Ghost: break;
  }
  const double shown = kPlainEdges / std::max(kPlainEdges, static_cast<double>(edges));
  return {0.16 * std::max(kLeastFilled, shown), std::max(kLeastShown, shown)};
}

osg::Vec4 faded(const osg::Vec4& colour, double by) {
  return {colour.r(), colour.g(), colour.b(), colour.a() * static_cast<float>(by)};
}

}  // namespace

osg::ref_ptr<osg::MatrixTransform> makeBody(const TriangleMesh& mesh, const Pose& X_WB, const osg::Vec4& colour,
                                            BodyStyle style, const ScenePalette& palette) {
  osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(toOsg(X_WB));
  const std::vector<Vector3> lines = featureEdges(mesh);
  const Opacity opacity = opacityOf(style, lines.size() / 2);
  osg::ref_ptr<osg::Geode> surface = new osg::Geode;
  surface->addDrawable(
      makeSurface(mesh, osg::Vec4(colour.r(), colour.g(), colour.b(), static_cast<float>(opacity.surface))));
  // Edges lie on the surface: push the surface back so that they are not torn.
  surface->getOrCreateStateSet()->setAttributeAndModes(new osg::PolygonOffset(1.0F, 1.0F));
  if (style != BodyStyle::Solid) makeTransparent(*surface);
  osg::ref_ptr<osg::Geode> edges = new osg::Geode;
  const osg::Vec4 edgeColour = faded(style == BodyStyle::Ghost ? colour : palette.lines, opacity.edges);
  const float width = (style == BodyStyle::SeeThrough ? 1.0F : 1.5F) * palette.pixelScale;
  edges->addDrawable(makeLines(lines, LineKind::Segments, edgeColour, width));
  transform->addChild(surface);
  transform->addChild(edges);
  return transform;
}

void setBodyColour(osg::MatrixTransform& body, const osg::Vec4& colour) {
  osg::Geometry* surface = body.getChild(0)->asGeode()->getDrawable(0)->asGeometry();
  auto* colours = static_cast<osg::Vec4Array*>(surface->getColorArray());
  const osg::Vec4 wanted(colour.r(), colour.g(), colour.b(), colours->front().a());
  if (colours->front() == wanted) return;
  colours->front() = wanted;
  colours->dirty();
  surface->dirtyGLObjects();
}

}  // namespace glissade
