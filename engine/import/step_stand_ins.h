#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "engine/import/step_entities.h"
#include "engine/import/step_stated_shapes.h"
#include "engine/import/step_tessellated.h"

namespace glissade {

/// A STEP text that OpenCASCADE 7.6 places and names as the file does, although it reads neither tessellated shapes nor
/// solids without a product.
struct StepStandIns {
  std::string text;  ///< empty: that of the file serves
  /// By the number of their item, which is a small solid in `text`: the triangles stand where it is placed.
  std::map<std::uint64_t, StepTessellation> tessellations;
};

/// - A tessellated item that is a body is replaced by a small solid, and its representation by one that is known.
/// - Items that are not read are replaced by a point.
/// - An orphan gets a product that has its name, or "solid_12" after its number.
/// - Lists of coordinates and triangles are emptied: OpenCASCADE's time grows with the square of their length.
StepStandIns standInsFor(const StepEntities& entities, const StatedShapes& stated);

}  // namespace glissade
