#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include <memory>
#include <vector>

#include "engine/planning/difficulty/help_places.h"
#include "widgets/scene3d/body_shape.h"
#include "widgets/scene3d/palette.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// Target of the hand: the selected place or, once the hand was moved there, the far end of its passage.
const Pose& helpTarget(const HelpPicture& help);

/// Draws the object at the target of the hand, the passage there, and the beginnings of the other places.
osg::ref_ptr<osg::Group> makeHelp(const HelpPicture& help, const LoadedScenario& scenario, BodyShapes& shapes,
                                  const ScenePalette& palette);

/// Labels of the missing clearance at each place that is not open; that of the selected one is strong.
std::vector<SceneLabel> helpLabels(const HelpPicture& help, double objectRadius);

}  // namespace glissade
