#pragma once

#include <vector>

#include "engine/import/step_assembly.h"

namespace glissade {

/// Reads an IGES file: its solids, and what is closed where its faces are sewn together (loose_parts.h). Names are
/// those of entities. Throws as readStepAssembly(). Runs in the importing process only.
StepAssembly readIgesParts(std::vector<char>& content);

}  // namespace glissade
