#pragma once

#include "engine/fits/measurement.h"

namespace glissade {

/// True if the features can be put onto each other; points of free surfaces cannot.
bool canAlign(const MeasureFeature& moving, const MeasureFeature& fixed);

/// True if there are two ways to align them: both features have a direction.
bool canFlip(const MeasureFeature& moving, const MeasureFeature& fixed);

/// The smallest motion of the world, for the body of `moving`, that puts the features into this relation. The table is
/// symmetric:
///
/// | | vertex | edge, axis | plane |
/// | --- | --- | --- | --- |
/// | vertex | in one point | on its line | in the plane |
/// | edge, axis | | collinear, in the direction that is nearer | edge: in the plane; cylinder: tangent to it |
/// | plane | | | coplanar, the faces face each other |
///
/// Cones and tori are replaced by their axes; a sphere is replaced by its centre, and is tangent to planes. The body
/// turns about the picked point (for a feature with an axis, about the point of the axis beside it) and then moves by
/// the smallest distance. `flipped`: collinear and coplanar with the opposite direction; an edge in the plane turned by
/// half a turn about itself; a cylinder on the other side of the plane (without `flipped`, a shaft is on the outer side
/// and a hole on the inner one). Both features are in the world frame. Precondition: canAlign().
Pose alignment(const MeasureFeature& moving, const MeasureFeature& fixed, bool flipped);

}  // namespace glissade
