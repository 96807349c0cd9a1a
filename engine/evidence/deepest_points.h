#pragma once

#include <vector>

#include "engine/geometry/triangle_pair.h"

namespace glissade::evidence {

/// Points of a flat part of one surface at which its depth below another surface can be largest.
///
/// The depth below a plane is linear on the part, and the depth below a surface is the distance from its nearest
/// triangle. The depth is therefore largest at a corner of the part, on an edge of it, or on the bisector of two
/// neighbouring triangles, where two planes are equally far. If it is constant between such points, their midpoint is
/// taken.
///
/// `near`: the triangles of the other surface that can be the nearest. The points belong to the part; some may be above
/// the surface.
std::vector<Vector3> deepestPoints(const Triangle& part, const std::vector<Triangle>& near);

}  // namespace glissade::evidence
