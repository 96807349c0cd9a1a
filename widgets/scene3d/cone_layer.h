#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include <vector>

#include "widgets/scene3d/palette.h"
#include "widgets/scene3d/scene_view.h"

namespace glissade {

/// A see-through cone for each direction that is forbidden, with its rim.
osg::ref_ptr<osg::Group> makeForbiddenCones(const std::vector<ForbiddenCone>& cones, const ScenePalette& palette);

}  // namespace glissade
