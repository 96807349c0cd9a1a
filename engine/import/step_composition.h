#pragma once

#include <functional>
#include <string>

#include "engine/base/result.h"
#include "engine/import/file_content.h"
#include "engine/import/step_answer.h"
#include "engine/import/step_import.h"

namespace glissade {

/// Reads one STEP file without those that it names.
using StepFileReader = std::function<Result<StepAnswer>(const FileContent&)>;

/// The product of `content` and of the files that it names for its parts, that those name, and so on. They are found
/// by findStepPart() and read once each. A file that is not there is a warning, with the parts that are missing; where
/// no part is left it is an error. A file that is there and cannot be read is an error, because the product would not
/// be what its files say. So are files that name each other in a circle, and more than import_protocol's numbers of
/// files, occurrences, parts and triangles, or mostFileBytes() of all files together.
Result<StepProduct> composeStepProduct(const FileContent& content, const StepFileReader& read);

}  // namespace glissade
