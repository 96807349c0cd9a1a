#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/import/cad_kind.h"

namespace glissade {

/// The order that the process gets which reads STEP, IGES and BREP.
struct StepImportOrder {
  CadKind kind;
  double deflection;       ///< millimetres, 0: by the size of each part
  bool solidNames = true;  ///< as in step_assembly.h
  /// Pairs of parts, by their paths, whose common volumes are written; empty: the parts are written.
  std::vector<std::pair<std::string, std::string>> volumesOf{};
};

/// The whole work of that process: gives up its rights, reads standard input, lets OpenCASCADE read and tessellate it,
/// writes the protocol's message. Returns the process's exit code.
int confinedStepImport(const StepImportOrder& order);

}  // namespace glissade
