#pragma once

#include <string>
#include <vector>

#include "engine/assembly/body_path.h"
#include "engine/base/result.h"
#include "engine/import/asset.h"

namespace glissade {

// Names of the parts of a STEP file: the names on the way to a part, as "pump/rotor". An assembly in the file
// ("pump") stands for all of its parts, the empty name for all of the file.

/// Names of the parts that a file holds; one that is empty where it holds one.
std::vector<std::string> namesOf(const LoadedGeometry& wholeFile);

/// The node that a person means: by its full name, or by its last name where no other has it. Errors are
/// MalformedInput with those that there are.
Result<std::string> nodeNamed(const std::string& name, const std::vector<std::string>& parts, const std::string& file);

/// The file holds no such part; says which it holds.
Diagnostic noSuchPart(const std::string& file, const std::string& name, const std::vector<std::string>& parts);

}  // namespace glissade
