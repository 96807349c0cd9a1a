#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include <vector>

#include "widgets/scene3d/palette.h"

namespace glissade {

/// Draws several paths, each in its colour; they show through the bodies.
osg::ref_ptr<osg::Group> makeKeptPaths(const std::vector<KeptPathPicture>& paths, const ScenePalette& palette);

}  // namespace glissade
