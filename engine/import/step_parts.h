#pragma once

#include <string>
#include <vector>

#include "engine/assembly/body_path.h"
#include "engine/assembly/product.h"
#include "engine/base/result.h"
#include "engine/import/asset.h"

namespace glissade {

// Names of the parts of a STEP file: the names on the way to a part, as "pump/rotor". An assembly in the file
// ("pump") stands for all of its parts, the empty name for all of the file.

/// Names of the parts that a file holds; one that is empty where it holds one.
std::vector<std::string> namesOf(const LoadedGeometry& wholeFile);

/// Its assemblies and parts, by their paths.
Product treeOf(const LoadedGeometry& wholeFile);

/// The path of the node that a person means: by its path, or by the end of it or of the names in the file where no
/// other ends in it. Errors are MalformedInput with those that there are.
Result<std::string> nodeNamed(const std::string& name, const Product& tree, const std::string& file);

/// The file holds no such part; says which it holds.
Diagnostic noSuchPart(const std::string& file, const std::string& name, const std::vector<std::string>& parts);

}  // namespace glissade
