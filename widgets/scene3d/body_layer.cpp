#include "widgets/scene3d/body_layer.h"

#include <osg/PolygonOffset>

#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

float alphaOf(BodyStyle style) {
  switch (style) {
    case BodyStyle::Solid: return 1.0F;
    case BodyStyle::SeeThrough: return 0.38F;
    case BodyStyle::Ghost: return 0.16F;
  }
  return 1.0F;
}

}  // namespace

osg::ref_ptr<osg::MatrixTransform> makeBody(const TriangleMesh& mesh, const Pose& X_WB, const osg::Vec4& colour,
                                            BodyStyle style, const ScenePalette& palette) {
  osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(toOsg(X_WB));
  osg::ref_ptr<osg::Geode> surface = new osg::Geode;
  surface->addDrawable(makeSurface(mesh, osg::Vec4(colour.r(), colour.g(), colour.b(), alphaOf(style))));
  // Edges lie on the surface: push the surface back so that they are not torn.
  surface->getOrCreateStateSet()->setAttributeAndModes(new osg::PolygonOffset(1.0F, 1.0F));
  if (style != BodyStyle::Solid) makeTransparent(*surface);
  osg::ref_ptr<osg::Geode> edges = new osg::Geode;
  const osg::Vec4 edgeColour = style == BodyStyle::Ghost ? colour : palette.lines;
  edges->addDrawable(
      makeFeatureEdges(mesh, edgeColour, (style == BodyStyle::SeeThrough ? 1.0F : 1.5F) * palette.pixelScale));
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
