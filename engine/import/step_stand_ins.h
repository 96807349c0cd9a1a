#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "engine/import/step_entities.h"
#include "engine/import/step_stated_shapes.h"
#include "engine/import/step_tessellated.h"

namespace glissade {

/// A STEP text from which OpenCASCADE 7.6 gets the places and names of the file, although it reads neither tessellated
/// shapes nor solids without a product.
struct StepStandIns {
  std::string text;  ///< empty: the text of the file can be used
  /// Tessellations by the number of their item, which is a small solid in `text`: the triangles are placed as that
  /// solid.
  std::map<std::uint64_t, StepTessellation> tessellations;
};

/// - A tessellated item that is a body is replaced by a small solid, and its representation by a known one.
/// - Items that are not read are replaced by a point.
/// - An orphan gets a product with its name, or "solid_12" by its number.
/// - Lists of coordinates and triangles are emptied: OpenCASCADE's time grows with the square of their length.
StepStandIns standInsFor(const StepEntities& entities, const StatedShapes& stated);

}  // namespace glissade
