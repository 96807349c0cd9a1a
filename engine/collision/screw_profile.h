#pragma once

#include <vector>

#include "engine/geometry/screw_axis.h"
#include "engine/geometry/triangle_pair.h"

namespace glissade {

/// Lower bound, metres, on the distance of two sets of triangles (world frame) while the first moves from its present
/// place by the screw motion, by any part of the advance (metres along the axis, any number of turns). Never above
/// `enough`; 0 where nothing is proved.
///
/// A screw motion does not change two numbers of a point: its distance r from the axis, and s = z - pitch * angle / 2
/// pi. s and s + pitch are the same helix. Threads that are apart in (r, s) are apart after any number of turns.
/// Triangles that are not apart in (r, s) may be apart by their distance from the axis, or by their height during the
/// motion. Triangles are divided where the bound is below `wanted`.
double screwDistance(const std::vector<Triangle>& moving, const std::vector<Triangle>& fixed, const ScrewAxis& screw,
                     double advance, double enough, double wanted);

}  // namespace glissade
