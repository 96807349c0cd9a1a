#pragma once

#include <string>
#include <vector>

#include "engine/import/step_face_entities.h"
#include "engine/import/step_tessellation.h"

namespace glissade {

/// Lines of the protocol about the healed faces of a part. `part` may be empty.
std::vector<std::string> healingNotes(const StepTriangles& triangles, const FaceEntities& entities,
                                      const std::string& part);

}  // namespace glissade
