#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include <vector>

#include "engine/files/end_conflicts.h"
#include "widgets/scene3d/body_shape.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// Draws the object at the refused end, the bodies that it meets there, and the curve where their surfaces meet, which
/// shows through everything.
osg::ref_ptr<osg::Group> makeRefusal(const EndConflicts& refusal, const LoadedScenario& scenario, BodyShapes& shapes,
                                     const ScenePalette& palette);

/// Labels of the depth, at the curve of each body.
std::vector<SceneLabel> refusalLabels(const EndConflicts& refusal);

}  // namespace glissade
