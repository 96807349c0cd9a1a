#include "widgets/scene3d/refusal_layer.h"

#include "widgets/scene3d/body_layer.h"
#include "widgets/scene3d/geometry_builder.h"

namespace glissade {
namespace {

constexpr float kCutWidth = 4.0F;

}  // namespace

osg::ref_ptr<osg::Group> makeRefusal(const EndConflicts& refusal, const LoadedScenario& scenario, BodyShapes& shapes,
                                     const ScenePalette& palette) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  osg::ref_ptr<osg::Geode> cuts = new osg::Geode;
  for (const EndConflict& conflict : refusal.conflicts) {
    const RigidBody& body = scenario.obstacles[conflict.obstacle];
    group->addChild(makeHighlight(shapes.of(body.mesh), body.X_WB, palette.penetration, palette));
    if (conflict.cut.empty()) continue;
    cuts->addDrawable(makeLines(conflict.cut, LineKind::Segments, palette.path, kCutWidth * palette.pixelScale));
  }
  makeOverlay(*cuts);
  group->addChild(makeGhost(shapes.of(scenario.object.mesh), refusal.q, palette.path, palette));
  group->addChild(cuts);
  return group;
}

std::vector<SceneLabel> refusalLabels(const EndConflicts& refusal) {
  std::vector<SceneLabel> labels;
  for (const EndConflict& conflict : refusal.conflicts) {
    if (!conflict.overlap || conflict.cut.empty()) continue;
    Box3 box;
    for (const Vector3& p : conflict.cut) box.extend(p);
    labels.push_back(lengthLabel(box.center(), *conflict.overlap, true));
  }
  return labels;
}

}  // namespace glissade
