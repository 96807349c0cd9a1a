#include "widgets/scene3d/measure_layer.h"

#include "widgets/scene3d/geometry_builder.h"

namespace glissade {
namespace {

constexpr float kMeasureWidth = 2.5F;
constexpr float kMeasurePoint = 9.0F;

}  // namespace

osg::ref_ptr<osg::Group> makeMeasure(const MeasurePicture& measure, const ScenePalette& palette) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  osg::ref_ptr<osg::Geode> geode = new osg::Geode;
  const float scale = palette.pixelScale;
  if (!measure.segments.empty()) {
    geode->addDrawable(makeLines(measure.segments, LineKind::Segments, palette.guidance, kMeasureWidth * scale));
  }
  if (!measure.points.empty()) {
    geode->addDrawable(makePoints(measure.points, palette.guidance, kMeasurePoint * scale));
  }
  makeOverlay(*geode);
  group->addChild(geode);
  return group;
}

}  // namespace glissade
