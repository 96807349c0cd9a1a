#pragma once

#include <vector>

#include "engine/sequence/product_fits.h"

namespace glissade {

/// Directions in which a body is tried to leave along a straight line, unit, world frame, no two alike, the likeliest
/// first: both ways along the axes that it has in common with others, the axes of the world (up first), both ways along
/// the normals of its large faces. They are where its contacts leave it free, if anywhere along a line (Wilson and
/// Latombe 1994).
std::vector<Vector3> removalDirections(const AssembledProduct& product, const ProductFits& fits, std::size_t body);

/// How far an object of this radius that leaves ends beyond the others' box, metres.
double leavingMargin(double radius);

/// The shortest way along the direction, metres, after which the inner box is beyond the outer one by the margin.
double wayOutOf(const Box3& inner, const Box3& outer, const Vector3& direction, double margin);

}  // namespace glissade
