#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/message.h"
#include "engine/import/step_entities.h"

namespace glissade {

/// The triangles of a TESSELLATED_SOLID, a TESSELLATED_SHELL, a TESSELLATED_GEOMETRIC_SET, or one of the triangulated
/// faces and surface sets of ISO 10303-42.
struct StepTessellation {
  std::vector<double> vertices;        ///< x y z, in the unit of the file, each position once
  std::vector<std::uint32_t> indices;  ///< three a triangle; counter-clockwise from outside if they enclose a volume
  Message fault;                       ///< reason why there are none; empty: there are some
};

/// Reads every face of the item, or returns a fault: a part of a body would be another body.
StepTessellation tessellationOf(const StepEntities& entities, std::uint64_t item);

}  // namespace glissade
