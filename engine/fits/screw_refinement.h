#pragma once

#include <vector>

#include "engine/geometry/screw_axis.h"

namespace glissade {

/// Refits a screw motion, which was fitted to the facets of a thread, to the thread's vertices. Facets are tilted
/// against their surface; vertices are on it. The axis equalizes the most frequent distances of vertices from it. The
/// pitch, from a third to three times the fitted one, puts the vertices of such a distance on the fewest helices.
ScrewAxis refinedScrew(const ScrewAxis& screw, const std::vector<Vector3>& vertices);

}  // namespace glissade
