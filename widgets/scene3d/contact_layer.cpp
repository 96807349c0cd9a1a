#include "widgets/scene3d/contact_layer.h"

#include <algorithm>
#include <cmath>

#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

constexpr float kPointSize = 8.0F;
constexpr double kDiscRadii = 1.2;    ///< radii of the object
constexpr double kDiscOfView = 0.10;  ///< largest share of the view's height

}  // namespace

ContactShown contactShown(const SessionSnapshot& snapshot) {
  const NearestObstacle& nearest = snapshot.device.nearest;
  if (nearest.body < 0 || nearest.distance <= 0.0 || !std::isfinite(nearest.distance)) return ContactShown::Nothing;
  const bool near = nearest.distance < snapshot.parameters[ParameterId::ContactDistance];
  return near ? ContactShown::Contact : ContactShown::Nearest;
}

osg::ref_ptr<osg::Group> makeContact(const SessionSnapshot& snapshot, const MarkScale& scale,
                                     const ScenePalette& palette) {
  const ContactShown shown = contactShown(snapshot);
  if (shown == ContactShown::Nothing) return nullptr;
  osg::ref_ptr<osg::Group> group = new osg::Group;
  const NearestObstacle& nearest = snapshot.device.nearest;
  const bool near = shown == ContactShown::Contact;
  const osg::Vec4 colour = near ? palette.contact : palette.nearest;
  osg::ref_ptr<osg::Geode> marks = new osg::Geode;
  const std::vector<Vector3> pair{nearest.p_WPo, nearest.p_WPn};
  marks->addDrawable(makeLines(pair, LineKind::Segments, colour, (near ? 3.0F : 1.5F) * palette.pixelScale));
  marks->addDrawable(makePoints(pair, colour, kPointSize * palette.pixelScale));
  // The marks show through all bodies, because they show where contact is.
  makeOverlay(*marks);
  group->addChild(marks);
  if (!near) return group;
  const double most = snapshot.parameters[ParameterId::ContactRadius];
  const double radius = std::min(most, scale.length(kDiscRadii, kDiscOfView));
  osg::ref_ptr<osg::Geode> plane = new osg::Geode;
  osg::Vec4 fill = palette.contact;
  fill.a() = snapshot.contactMode ? 0.35F : 0.15F;
  plane->addDrawable(makeDisc(nearest.p_WPo, nearest.normal_W(), radius, fill));
  group->addChild(plane);
  return group;
}

}  // namespace glissade
