#pragma once

#include <vector>

#include "engine/import/importer_process.h"
#include "engine/import/step_import.h"
#include "engine/model/missing_shape.h"

namespace glissade {

/// A product that a STEP file places and that is in another file.
struct StepExternal {
  std::string path;  ///< see Occurrence::path; below the root
  Pose X_FP;
  std::string file;                ///< name in the STEP file
  std::vector<NodeNames> names{};  ///< see Occurrence::names
};

/// The content of one STEP file.
struct StepAnswer {
  std::string rootName;           ///< name of the only product of the file if that is no assembly; else empty
  std::vector<Occurrence> parts;  ///< with their paths below the root; may be empty if there are `externals`
  std::vector<StepExternal> externals;
  Warnings warnings;
  MissingShapes missing{};  ///< missing shapes, without the file's name
};

/// Decodes the output of glissade-import-step. Every count, number, index and name is checked, because the file may
/// have captured the program. Errors are MalformedInput with the file's name.
Result<StepAnswer> decodeStepAnswer(const ImporterCall& call, ImporterAnswer& answer);

}  // namespace glissade
