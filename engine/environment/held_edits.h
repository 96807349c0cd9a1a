#pragma once

#include "engine/assembly/product.h"
#include "engine/environment/attribute.h"

namespace glissade {

/// The edits as they count: what is said of an assembly is said of each body below it, unless the body, or an assembly
/// between them, says otherwise. Nothing is said of assemblies any more.
SemanticEdits heldEdits(SemanticEdits edits, const Product& product);

}  // namespace glissade
