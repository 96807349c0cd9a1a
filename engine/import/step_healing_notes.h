#pragma once

#include <string>
#include <vector>

#include "engine/import/step_face_entities.h"
#include "engine/import/step_tessellation.h"

namespace glissade {

/// What was done to the faces of a part whose triangles were wrong, as lines of the protocol. `part` may be empty.
std::vector<std::string> healingNotes(const StepTriangles& triangles, const FaceEntities& entities,
                                      const std::string& part);

}  // namespace glissade
