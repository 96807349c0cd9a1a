#pragma once

#include <functional>
#include <vector>

#include "engine/sequence/product_fits.h"

namespace glissade {

/// Directions in which a removal of the body along a straight line is tried, unit, world frame, without duplicates, the
/// likeliest first: both senses of the axes that it shares with other bodies, the axes of the world (up first), and
/// both senses of the normals of its large faces. If contacts leave the body free along a line, then along one of these
/// (Wilson and Latombe 1994).
std::vector<Vector3> removalDirections(const AssembledProduct& product, const ProductFits& fits, std::size_t body);

/// 1: the direction is upwards; -1: downwards; 0: sideways. Both are unit vectors; the slope of an upward direction is
/// at least 45 degrees.
int senseOf(const Vector3& direction, const Vector3& up);

/// Distance from the box of the other bodies at which a leaving object of this radius ends, metres.
double leavingMargin(double radius);

/// The shortest displacement along the direction, metres, that moves the inner box out of the outer one by the margin.
double wayOutOf(const Box3& inner, const Box3& outer, const Vector3& direction, double margin);

/// How far a box moves along these displacements, one after the other, until it is beside none of the other boxes,
/// metres. 0: there is no other box.
double lengthBeside(const Box3& box, const std::vector<Box3>& others, const std::vector<Vector3>& ways);

/// How far the bodies of the group slide along the bodies of `others` that they fit with, while the group moves along
/// these displacements, metres. `boxOf`: box of a body where the product is assembled, world frame.
double slideOf(const BodyGroup& group, const std::vector<Vector3>& ways, const BodySet& others, const ProductFits& fits,
               const std::function<Box3(std::size_t body)>& boxOf);

}  // namespace glissade
