#include "widgets/scene3d/contact_layer.h"

#include <cmath>

#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

constexpr float kPointSize = 8.0F;
/// Share of the contact disc that is drawn: all of it would hide the scene.
constexpr double kDrawnDisc = 0.5;

}  // namespace

osg::ref_ptr<osg::Group> makeContact(const SessionSnapshot& snapshot, const ScenePalette& palette) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  const NearestObstacle& nearest = snapshot.device.nearest;
  if (nearest.body < 0 || nearest.distance <= 0.0 || !std::isfinite(nearest.distance)) return group;
  const bool near = nearest.distance < snapshot.parameters[ParameterId::ContactDistance];
  const osg::Vec4 colour = near ? palette.contact : palette.nearest;
  osg::ref_ptr<osg::Geode> marks = new osg::Geode;
  const std::vector<Vector3> pair{nearest.p_WPo, nearest.p_WPn};
  marks->addDrawable(makeLines(pair, LineKind::Segments, colour, (near ? 3.0F : 1.5F) * palette.pixelScale));
  marks->addDrawable(makePoints(pair, colour, kPointSize * palette.pixelScale));
  // Seen through whatever lies in front: it tells where contact is.
  makeOverlay(*marks);
  group->addChild(marks);
  if (!near) return group;
  const double radius = kDrawnDisc * snapshot.parameters[ParameterId::ContactRadius];
  osg::ref_ptr<osg::Geode> plane = new osg::Geode;
  osg::Vec4 fill = palette.contact;
  fill.a() = snapshot.contactMode ? 0.35F : 0.15F;
  plane->addDrawable(makeDisc(nearest.p_WPo, nearest.normal_W(), radius, fill));
  group->addChild(plane);
  return group;
}

}  // namespace glissade
