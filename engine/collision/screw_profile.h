#pragma once

#include <vector>

#include "engine/geometry/screw_axis.h"
#include "engine/geometry/triangle_pair.h"

namespace glissade {

/// Lower bound, metres, on the distance of two sets of triangles (world frame) while the first moves by the screw
/// motion from where it is, by any part of the advance (metres along the axis, any number of turns). Never above
/// `enough`; 0 where nothing is shown.
///
/// A screw motion leaves two numbers of a point alone: its distance r from the axis, and s = z - pitch * angle / 2 pi,
/// of which a pitch more or less is the same. Threads that are apart in (r, s) stay so for any number of turns. Where
/// triangles are not apart in (r, s), their distance from the axis and their height on the way may keep them apart.
double screwDistance(const std::vector<Triangle>& moving, const std::vector<Triangle>& fixed, const ScrewAxis& screw,
                     double advance, double enough);

}  // namespace glissade
