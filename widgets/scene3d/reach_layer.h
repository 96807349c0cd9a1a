#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include "widgets/scene3d/body_shape.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// Draws hand, forearm and tool as bodies, in the colour of penetration if they do not reach their place.
osg::ref_ptr<osg::Group> makeReach(const ReachPicture& reach, BodyShapes& shapes, const ScenePalette& palette);

/// Empty if nothing is shown.
Box3 boxOfReach(const ReachPicture& reach);

/// The colour of a hand.
osg::Vec4 reachColour(bool isFree, const ScenePalette& palette);

}  // namespace glissade
