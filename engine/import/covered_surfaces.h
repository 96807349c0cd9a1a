#pragma once

#include "engine/import/step_import.h"

namespace glissade {

/// Leaves out each surface without an inside that lies within a solid of its own part, as cosmetic threads do: the
/// solid covers it, so that nothing of the product is missing. The warning about the surface says so. `file`: name of
/// the product's file. A surface counts as within the solid if no point is farther outside than the deflections of
/// both.
void leaveOutCoveredSurfaces(StepProduct& product, const std::string& file);

}  // namespace glissade
