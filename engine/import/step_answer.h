#pragma once

#include <vector>

#include "engine/import/importer_process.h"
#include "engine/import/step_import.h"

namespace glissade {

/// The product in what glissade-import-step wrote. Every count, number, index and name is checked: the program may have
/// been captured by its file. Errors are MalformedInput with the file's name.
Result<StepProduct> decodeStepAnswer(const ImporterCall& call, ImporterAnswer& answer);

}  // namespace glissade
