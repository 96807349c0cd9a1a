#pragma once

#include <functional>
#include <string>

#include "engine/base/result.h"
#include "engine/import/file_content.h"
#include "engine/import/step_answer.h"
#include "engine/import/step_import.h"

namespace glissade {

/// Reads one STEP file without the files that it names.
using StepFileReader = std::function<Result<StepAnswer>(const FileContent&)>;

/// The product of `content`, with the files that it names for its parts, the files that those name, and so on. They are
/// found by findStepPart() and read once each. A file that does not exist is a warning, with the missing parts; if no
/// part is left, it is an error. An existing file that cannot be read is an error, because the product would differ
/// from its files. Errors are also files that name each other in a circle, and more files, occurrences, parts and
/// triangles than import_protocol permits, or more than mostFileBytes() of all files together.
Result<StepProduct> composeStepProduct(const FileContent& content, const StepFileReader& read);

}  // namespace glissade
