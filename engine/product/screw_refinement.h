#pragma once

#include <vector>

#include "engine/geometry/screw_axis.h"

namespace glissade {

/// A screw motion that was fitted to the facets of a thread, fitted again to its vertices. Facets are tilted against
/// the surface that they stand for; vertices lie on it. The axis makes the most frequent distances of vertices from it
/// equal. The pitch, from a third to three times the fitted one, makes the vertices of such a distance lie on the
/// fewest helices.
ScrewAxis refinedScrew(const ScrewAxis& screw, const std::vector<Vector3>& vertices);

}  // namespace glissade
