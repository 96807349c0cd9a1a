#include "widgets/scene3d/difficulty_layer.h"

#include "widgets/scene3d/body_layer.h"
#include "widgets/scene3d/geometry_builder.h"

namespace glissade {
namespace {

constexpr float kWayWidth = 4.0F;
constexpr float kGapWidth = 2.0F;
constexpr float kMarkSize = 12.0F;

/// The body that blocks the object at the deepest place, or else between the trees.
int blockingBody(const Difficulty& difficulty) {
  if (difficulty.leastPenetration) return difficulty.leastPenetration->body;
  return difficulty.frontier ? difficulty.frontier->body : -1;
}

void addWay(const LeastPenetration& least, const ScenePalette& palette, osg::Geode& marks) {
  std::vector<Vector3> way;
  for (const Pose& q : least.way) way.push_back(q.position);
  marks.addDrawable(makeLines(way, LineKind::Strip, palette.penetration, kWayWidth * palette.pixelScale));
  marks.addDrawable(makePoints({least.q.position}, palette.penetration, kMarkSize * palette.pixelScale));
}

void addGap(const Difficulty::Frontier& frontier, const ScenePalette& palette, osg::Geode& marks) {
  const std::vector<Vector3> ends{frontier.fromStart.position, frontier.fromGoal.position};
  marks.addDrawable(makeLines(ends, LineKind::Segments, palette.nearest, kGapWidth * palette.pixelScale));
  marks.addDrawable(makePoints(ends, palette.nearest, 0.5F * kMarkSize * palette.pixelScale));
}

}  // namespace

osg::ref_ptr<osg::Group> makeDifficulty(const Difficulty& difficulty, const LoadedScenario& scenario,
                                        BodyShapes& shapes, const ScenePalette& palette) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  const BodyShape& object = shapes.of(scenario.object.mesh);
  if (const int body = blockingBody(difficulty); body >= 0) {
    const RigidBody& blocking = scenario.obstacles[static_cast<std::size_t>(body)];
    group->addChild(makeHighlight(shapes.of(blocking.mesh), blocking.X_WB, palette.penetration, palette));
  }
  osg::ref_ptr<osg::Geode> marks = new osg::Geode;
  if (difficulty.frontier) addGap(*difficulty.frontier, palette, *marks);
  if (difficulty.tightest) {
    group->addChild(makeGhost(object, difficulty.tightest->q, palette.nearest, palette));
  }
  if (const auto& least = difficulty.leastPenetration) {
    group->addChild(makeMovedBody(object, least->q, palette.penetration, palette));
    addWay(*least, palette, *marks);
  }
  // The marks show through all bodies, because they show where to look.
  makeOverlay(*marks);
  group->addChild(marks);
  return group;
}

std::vector<SceneLabel> difficultyLabels(const Difficulty& difficulty) {
  std::vector<SceneLabel> labels;
  if (const auto& least = difficulty.leastPenetration) {
    labels.push_back(lengthLabel(least->q.position, least->depth, true));
  }
  if (const auto& tightest = difficulty.tightest) {
    labels.push_back(lengthLabel(tightest->q.position, tightest->clearance, false));
    labels.back().below = true;
  }
  return labels;
}

}  // namespace glissade
