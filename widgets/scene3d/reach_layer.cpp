#include "widgets/scene3d/reach_layer.h"

#include "widgets/scene3d/body_layer.h"

namespace glissade {
namespace {

/// The colour of a glove, which is neither a colour of the scene nor of skin.
const osg::Vec4 kGlove(0.80F, 0.72F, 0.58F, 1.0F);
const osg::Vec4 kSteel(0.48F, 0.52F, 0.57F, 1.0F);

}  // namespace

osg::Vec4 reachColour(bool isFree, const ScenePalette& palette) { return isFree ? kGlove : palette.penetration; }

Box3 boxOfReach(const ReachPicture& reach) {
  Box3 box;
  for (const ReachPicture::Part& part : reach.parts) box.extend(boundingBox(*part.mesh, part.X_WM));
  return box;
}

osg::ref_ptr<osg::Group> makeReach(const ReachPicture& reach, BodyShapes& shapes, const ScenePalette& palette) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  for (const ReachPicture::Part& part : reach.parts) {
    const osg::Vec4 colour = part.isTool ? kSteel : reachColour(reach.isFree, palette);
    const DisplayMode mode = part.isTool ? DisplayMode::ShadedWithEdges : DisplayMode::Shaded;
    group->addChild(makeBody(shapes.of(part.mesh), part.X_WM, colour, mode, palette));
  }
  return group;
}

}  // namespace glissade
