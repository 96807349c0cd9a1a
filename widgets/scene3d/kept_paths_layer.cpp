#include "widgets/scene3d/kept_paths_layer.h"

#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/osg_convert.h"

namespace glissade {
namespace {

constexpr float kKeptPathWidth = 3.5F;
constexpr float kKeptPathPoint = 7.0F;

}  // namespace

osg::ref_ptr<osg::Group> makeKeptPaths(const std::vector<KeptPathPicture>& paths, const ScenePalette& palette) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  for (const KeptPathPicture& path : paths) {
    if (path.way.empty()) continue;
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    const osg::Vec4 colour = toOsg(path.colour);
    geode->addDrawable(makeLines(path.way, LineKind::Strip, colour, kKeptPathWidth * palette.pixelScale));
    geode->addDrawable(makePoints({path.way.front(), path.way.back()}, colour, kKeptPathPoint * palette.pixelScale));
    makeOverlay(*geode);  // paths lie between bodies and in their holes
    group->addChild(geode);
  }
  return group;
}

}  // namespace glissade
