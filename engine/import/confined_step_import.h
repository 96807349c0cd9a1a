#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/import/cad_kind.h"

namespace glissade {

/// The task of the process that reads STEP, IGES and BREP.
struct StepImportOrder {
  CadKind kind;
  double deflection;       ///< millimetres; 0: chosen by the size of each part
  bool solidNames = true;  ///< see readStepAssembly()
  /// Pairs of parts, by their paths, whose common volumes are written; empty: the parts are written.
  std::vector<std::pair<std::string, std::string>> volumesOf{};
};

/// The work of that process: gives up its rights, reads standard input, lets OpenCASCADE read and tessellate it, and
/// writes the protocol's message. Returns the exit code of the process.
int confinedStepImport(const StepImportOrder& order);

}  // namespace glissade
