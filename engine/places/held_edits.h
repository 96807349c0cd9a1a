#pragma once

#include "engine/model/product.h"
#include "engine/places/attribute.h"

namespace glissade {

/// The edits with their effect on bodies: an attribute of an assembly holds for each body below it, unless the body, or
/// an assembly between them, has its own value. The result has no attributes of assemblies.
SemanticEdits heldEdits(SemanticEdits edits, const Product& product);

}  // namespace glissade
