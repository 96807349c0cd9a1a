#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/import/asset.h"
#include "engine/model/body_path.h"
#include "engine/model/product.h"

namespace glissade {

// Names of the parts of a STEP file: the names on the path to a part, as "pump/rotor". An assembly ("pump") stands for
// all of its parts, the empty name for the whole file.

/// Names of the parts of a file; one empty name if it has one part.
std::vector<std::string> namesOf(const LoadedGeometry& wholeFile);

/// Tree of the assemblies and parts of a file, by their paths.
Product treeOf(const std::vector<Occurrence>& parts);

/// The path of the node that a person means: by its path, or by a unique end of the path or of the names in the file.
/// Errors are MalformedInput with the existing names.
Result<std::string> nodeNamed(const std::string& name, const Product& tree, const std::string& file);

/// The error for a name that no part of the file has, with the names of the parts.
Diagnostic noSuchPart(const std::string& file, const std::string& name, const std::vector<std::string>& parts);

}  // namespace glissade
