#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

namespace glissade {

/// A group that lights its children. The lights turn with the view, so that faces of different directions differ in
/// brightness from each viewpoint.
osg::ref_ptr<osg::Group> makeLights();

}  // namespace glissade
