#pragma once

#include "engine/import/cad_kind.h"

namespace glissade {

/// The whole work of the process that reads STEP, IGES and BREP: gives up its rights, reads standard input, lets
/// OpenCASCADE read and tessellate it, writes the protocol's message. `deflection` in millimetres, 0: by
/// the size of each part. `solidNames`: as in step_assembly.h. Returns the process's exit code.
int confinedStepImport(CadKind kind, double deflection, bool solidNames);

}  // namespace glissade
