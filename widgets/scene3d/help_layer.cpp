#include "widgets/scene3d/help_layer.h"

#include "widgets/scene3d/body_layer.h"
#include "widgets/scene3d/geometry_builder.h"
#include "widgets/scene3d/guidance_layer.h"

namespace glissade {
namespace {

constexpr float kPassageWidth = 3.0F;
constexpr float kPlaceMark = 10.0F;

}  // namespace

const Pose& helpTarget(const HelpPicture& help) {
  const HelpPlace& place = (*help.places)[help.chosen];
  return help.taken ? place.fromGoal : place.fromStart;
}

osg::ref_ptr<osg::Group> makeHelp(const HelpPicture& help, const LoadedScenario& scenario, BodyShapes& shapes,
                                  const ScenePalette& palette) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  group->addChild(makeSeenGhost(shapes.of(scenario.object.mesh), helpTarget(help), palette.guidance, palette));
  osg::ref_ptr<osg::Geode> marks = new osg::Geode;
  std::vector<Vector3> passage;
  for (const Pose& q : (*help.places)[help.chosen].passage) passage.push_back(q.position);
  marks->addDrawable(makeLines(passage, LineKind::Strip, palette.guidance, kPassageWidth * palette.pixelScale));
  std::vector<Vector3> ends;
  for (const HelpPlace& place : *help.places) ends.push_back(place.fromStart.position);
  marks->addDrawable(makePoints(ends, palette.guidance, kPlaceMark * palette.pixelScale));
  makeDrawing(*marks);
  makeOverlay(*marks);
  makeAvoidMarks(*marks);
  group->addChild(marks);
  return group;
}

std::vector<SceneLabel> helpLabels(const HelpPicture& help, double objectRadius) {
  std::vector<SceneLabel> labels;
  for (std::size_t i = 0; i < help.places->size(); ++i) {
    const HelpPlace& place = (*help.places)[i];
    if (!place.lacking || isOpen(place, objectRadius)) continue;
    labels.push_back(lengthLabel(place.narrowest.position, *place.lacking, i == help.chosen));
  }
  return labels;
}

}  // namespace glissade
