#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include "engine/planning/difficulty/difficulty.h"
#include "widgets/scene3d/body_shape.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// Shows why no path was found: the path of least penetration with the object at its deepest place and the body that
/// blocks it there, the gap between the trees, and the object in the tightest passage.
osg::ref_ptr<osg::Group> makeDifficulty(const Difficulty& difficulty, const LoadedScenario& scenario,
                                        BodyShapes& shapes, const ScenePalette& palette);

/// Labels of depth and tightness at their places.
std::vector<SceneLabel> difficultyLabels(const Difficulty& difficulty);

}  // namespace glissade
