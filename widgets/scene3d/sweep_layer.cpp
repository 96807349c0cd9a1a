#include "widgets/scene3d/sweep_layer.h"

#include <osg/CullFace>
#include <osg/Geode>

#include "widgets/scene3d/body_shape.h"
#include "widgets/scene3d/geometry_builder.h"

namespace glissade {
namespace {

constexpr float kSweepFill = 0.30F;

}  // namespace

osg::ref_ptr<osg::Group> makeSweep(const TriangleMesh& surface_W, const ScenePalette& palette) {
  osg::Vec4 colour = palette.contact;
  colour.a() = kSweepFill;
  osg::ref_ptr<osg::Geode> surface = new osg::Geode;
  surface->addDrawable(makeSurface(makeBodyShape(surface_W), colour));
  // The inner side is culled, because it would be blended over the outer one in the order of the triangles.
  surface->getOrCreateStateSet()->setAttributeAndModes(new osg::CullFace(osg::CullFace::BACK));
  makeTransparent(*surface);
  osg::ref_ptr<osg::Group> group = new osg::Group;
  group->addChild(surface);
  return group;
}

}  // namespace glissade
