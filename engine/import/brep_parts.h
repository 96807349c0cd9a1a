#pragma once

#include <istream>

#include "engine/import/step_assembly.h"

namespace glissade {

/// Reads a BREP file, OpenCASCADE's own text: its solids, and what is closed where its faces are sewn together
/// (loose_parts.h). It states neither names nor units; its numbers are millimetres. Throws as readStepAssembly(). Runs
/// in the importing process only.
StepAssembly readBrepParts(std::istream& content);

}  // namespace glissade
