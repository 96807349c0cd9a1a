#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include "widgets/scene3d/palette.h"

namespace glissade {

/// Draws lines and points of a measurement, which show through everything.
osg::ref_ptr<osg::Group> makeMeasure(const MeasurePicture& measure, const ScenePalette& palette);

}  // namespace glissade
