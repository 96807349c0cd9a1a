#pragma once

#include <vector>

#include "engine/import/step_assembly.h"

namespace glissade {

/// Reads an IGES file: its solids, and closed shells that sewing makes of loose faces (loose_parts.h). Names are those
/// of entities. Throws as readStepAssembly() does. Runs in the importing process only.
StepAssembly readIgesParts(std::vector<char>& content);

}  // namespace glissade
