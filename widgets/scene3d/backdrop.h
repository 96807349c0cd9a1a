#pragma once

#include <osg/Camera>
#include <osg/ref_ptr>

#include "widgets/scene3d/palette.h"

namespace glissade {

/// Makes a vertical gradient behind everything.
osg::ref_ptr<osg::Camera> makeBackdrop(const ScenePalette& palette);

}  // namespace glissade
