#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

namespace glissade {

/// A group that lights its children. The lights turn with the view: faces of different directions differ in brightness
/// from wherever one looks.
osg::ref_ptr<osg::Group> makeLights();

}  // namespace glissade
