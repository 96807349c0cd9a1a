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

/// Where the hand is to go: to the place that was chosen or, from there, through its passage.
const Pose& helpTarget(const HelpPicture& help);

/// The object where the hand is to go, the passage there, and the beginnings of the other places.
osg::ref_ptr<osg::Group> makeHelp(const HelpPicture& help, const LoadedScenario& scenario, BodyShapes& shapes,
                                  const ScenePalette& palette);

/// An arrow from where the object is to where the hand is to go. Null where it is there.
osg::ref_ptr<osg::Group> makeHelpArrow(const HelpPicture& help, const Pose& q_device, const MarkScale& scale,
                                       const ScenePalette& palette);

/// What the object lacks at each place that is not open, the chosen one's strong.
std::vector<SceneLabel> helpLabels(const HelpPicture& help, double objectRadius);

}  // namespace glissade
