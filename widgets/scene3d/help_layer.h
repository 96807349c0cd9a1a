#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include <memory>
#include <vector>

#include "engine/planning/difficulty/help_places.h"
#include "widgets/scene3d/body_shape.h"
#include "widgets/scene3d/mark_size.h"
#include "widgets/scene3d/palette.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// Target of the hand: the selected place or, once the hand was moved there, the far end of its passage.
const Pose& helpTarget(const HelpPicture& help);

/// Draws the object at the target of the hand, the passage there, and the beginnings of the other places.
osg::ref_ptr<osg::Group> makeHelp(const HelpPicture& help, const LoadedScenario& scenario, BodyShapes& shapes,
                                  const ScenePalette& palette);

/// Draws an arrow from the object along the passage, which the hand was moved to. It ends where the passage is in
/// sight, at most half a radius ahead of the object. `sight`: a query of pointWorld(). Null before the hand was moved
/// there, at the end, and where no part of the passage is in sight.
osg::ref_ptr<osg::Group> makeHelpArrow(const HelpPicture& help, const Pose& q_device, double objectRadius,
                                       CollisionQuery& sight, const MarkScale& scale, const ScenePalette& palette);

/// Labels of the missing clearance at each place that is not open; that of the selected one is strong.
std::vector<SceneLabel> helpLabels(const HelpPicture& help, double objectRadius);

}  // namespace glissade
