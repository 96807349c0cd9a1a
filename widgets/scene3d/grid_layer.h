#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include "widgets/scene3d/palette.h"

namespace glissade {

/// A grid of lines on the ground, across z.
struct GroundGrid {
  Vector3 centre = Vector3::Zero();
  double spacing = 1.0;  ///< metres between two lines
  double reach = 10.0;   ///< metres from the centre, at which it has faded
};

/// A grid under the box of a product. Its lines are at whole multiples of the spacing, which is 1, 2 or 5 times a power
/// of ten in a unit of `unit` metres. Precondition: the box is not empty.
GroundGrid groundGridUnder(const Box3& box, double unit);

/// Draws the grid. Every tenth line is stronger; the lines through the origin have the colours of the axes.
osg::ref_ptr<osg::Group> makeGrid(const GroundGrid& grid, const ScenePalette& palette);

}  // namespace glissade
