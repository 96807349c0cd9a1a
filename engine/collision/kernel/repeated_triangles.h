#pragma once

#include <vector>

#include "engine/collision/kernel/box_tree.h"

namespace glissade {

/// Drops each triangle that has the corners of an earlier one of the same body, in whatever order. Files for display
/// have every face twice, once for each side: as sets of points the bodies are the same, with a quarter of the pairs.
void dropRepeated(std::vector<OwnedTriangle>& triangles);

}  // namespace glissade
