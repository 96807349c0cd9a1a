#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include <vector>

#include "widgets/scene3d/palette.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// Makes a see-through cone with its rim for each forbidden direction.
osg::ref_ptr<osg::Group> makeForbiddenCones(const std::vector<ForbiddenCone>& cones, const ScenePalette& palette);

}  // namespace glissade
