#pragma once

#include <string>
#include <vector>

#include "engine/import/step_assembly.h"

namespace glissade {

/// The volume that two parts of the assembly share, cubic millimetres: the sum of OpenCASCADE's common volumes of their
/// solids. A part is a path of the assembly with all nodes below it. Not a number if one of the parts has no solid, or
/// if OpenCASCADE cannot intersect the solids. Runs in the importing process only.
double commonVolume(const StepAssembly& assembly, const std::string& a, const std::string& b);

}  // namespace glissade
