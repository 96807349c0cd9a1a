#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include <vector>

#include "engine/scenario/end_conflicts.h"
#include "widgets/scene3d/body_shape.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// The object at the end that is refused, the bodies that it meets there, and the curve where their surfaces meet,
/// which shows through everything.
osg::ref_ptr<osg::Group> makeRefusal(const EndConflicts& refusal, const LoadedScenario& scenario, BodyShapes& shapes,
                                     const ScenePalette& palette);

/// How deep, at the curve of each body.
std::vector<SceneLabel> refusalLabels(const EndConflicts& refusal);

}  // namespace glissade
