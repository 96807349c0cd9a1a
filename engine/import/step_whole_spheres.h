#pragma once

#include "engine/import/step_edited_text.h"
#include "engine/import/step_entities.h"

namespace glissade {

/// Handles a spherical face whose only boundary runs along a circle and back, which bounds a whole sphere. OpenCASCADE
/// 7.6 makes no triangles of it, so the boundary is replaced by a vertex, as other programs write a whole sphere.
void makeSlitSpheresWhole(const StepEntities& entities, StepEditedText& edited);

}  // namespace glissade
