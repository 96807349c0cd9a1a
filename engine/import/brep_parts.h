#pragma once

#include <istream>

#include "engine/import/step_assembly.h"

namespace glissade {

/// Reads a BREP file, the text format of OpenCASCADE: its solids, and closed shells that sewing makes of loose faces
/// (loose_parts.h). The format states neither names nor units; its numbers are millimetres. Throws as
/// readStepAssembly() does. Runs in the importing process only.
StepAssembly readBrepParts(std::istream& content);

}  // namespace glissade
