#pragma once

#include <vector>

#include "engine/assembly/missing_shape.h"
#include "engine/import/importer_process.h"
#include "engine/import/step_import.h"

namespace glissade {

/// A product that a STEP file places and another file has.
struct StepExternal {
  std::string path;  ///< as of Occurrence, below the root
  Pose X_FP;
  std::string file;                ///< as the STEP file names it
  std::vector<NodeNames> names{};  ///< as of Occurrence
};

/// What one STEP file holds itself.
struct StepAnswer {
  std::string rootName;           ///< of the one product of the file, where it is no assembly; else empty
  std::vector<Occurrence> parts;  ///< with their paths below the root; none where `externals` has some
  std::vector<StepExternal> externals;
  Warnings warnings;
  MissingShapes missing{};  ///< without their file
};

/// What glissade-import-step wrote. Every count, number, index and name is checked: the program may have
/// been captured by its file. Errors are MalformedInput with the file's name.
Result<StepAnswer> decodeStepAnswer(const ImporterCall& call, ImporterAnswer& answer);

}  // namespace glissade
