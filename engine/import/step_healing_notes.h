#pragma once

#include <string>

#include "engine/import/step_face_entities.h"
#include "engine/import/step_note.h"
#include "engine/import/step_tessellation.h"

namespace glissade {

/// Notes about the healed faces of a part. `part` may be empty.
StepNotes healingNotes(const StepTriangles& triangles, const FaceEntities& entities, const std::string& part);

}  // namespace glissade
