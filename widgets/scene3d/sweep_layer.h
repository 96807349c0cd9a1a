#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include "engine/geometry/triangle_mesh.h"
#include "widgets/scene3d/palette.h"

namespace glissade {

/// Draws a swept volume as a see-through surface, so that the path and the bodies in it are visible.
osg::ref_ptr<osg::Group> makeSweep(const TriangleMesh& surface_W, const ScenePalette& palette);

}  // namespace glissade
