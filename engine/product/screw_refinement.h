#pragma once

#include <vector>

#include "engine/geometry/screw_axis.h"

namespace glissade {

/// The screw motion that was fitted to the facets of a thread, from the vertices of the thread: facets are tilted
/// against the surface that they stand for, vertices lie on it. The axis is the one that makes the vertices' most
/// frequent distances from it equal; the pitch the one, from a third to three times the
/// fitted one, that makes the vertices of such a
/// distance lie on the fewest helices.
ScrewAxis refinedScrew(const ScrewAxis& screw, const std::vector<Vector3>& vertices);

}  // namespace glissade
