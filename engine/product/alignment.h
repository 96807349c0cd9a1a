#pragma once

#include "engine/product/measurement.h"

namespace glissade {

/// The features can be put onto each other: all but points of free surfaces.
bool canAlign(const MeasureFeature& moving, const MeasureFeature& fixed);

/// There are two ways of doing so: both features have a direction.
bool canFlip(const MeasureFeature& moving, const MeasureFeature& fixed);

/// The least motion of the world, for the body of `moving`, after which the features are related so, whichever of them
/// moves:
///
/// | | vertex | edge, axis | plane |
/// | --- | --- | --- | --- |
/// | vertex | in one point | on its line | in the plane |
/// | edge, axis | | collinear, in the direction that is nearer | edge: in the plane; cylinder: tangent to it |
/// | plane | | | coplanar, the faces look at each other |
///
/// Cones and tori count as their axes; a sphere counts as its centre, and is tangent to planes. It turns about the
/// point that was picked (of what has an axis, the point of the axis beside it) and then moves by the least distance.
/// `flipped`: collinear and coplanar in the other direction; an edge in the plane turned by half a turn about itself; a
/// cylinder on the other side of the plane, which is at first the outer side for a shaft and the inner one for a hole.
/// Both features in the world. Precondition: canAlign().
Pose alignment(const MeasureFeature& moving, const MeasureFeature& fixed, bool flipped);

}  // namespace glissade
