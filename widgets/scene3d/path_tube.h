#pragma once

#include <osg/Geometry>
#include <osg/ref_ptr>

#include <vector>

#include "engine/geometry/pose.h"

namespace glissade {

/// A point of a tube, with its colour there.
struct TubePoint {
  Vector3 p_W;
  osg::Vec4 colour;
};

/// A lit tube along the points; its colours run from one to the next. Equal points that follow each other change the
/// colour at once.
osg::ref_ptr<osg::Geometry> makeTube(const std::vector<TubePoint>& points, double radius);

}  // namespace glissade
