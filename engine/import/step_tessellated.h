#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/import/step_entities.h"

namespace glissade {

/// The triangles of a TESSELLATED_SOLID, a TESSELLATED_SHELL, a TESSELLATED_GEOMETRIC_SET, or one of the triangulated
/// faces and surface sets of ISO 10303-42.
struct StepTessellation {
  std::vector<double> vertices;        ///< x y z, in the unit of the file, each position once
  std::vector<std::uint32_t> indices;  ///< three a triangle; counter-clockwise from outside where they enclose a volume
  std::string fault;                   ///< why there are none; empty: there are some
};

/// Every face of it is read, or there is a fault: a part of a body would not be the body.
StepTessellation tessellationOf(const StepEntities& entities, std::uint64_t item);

}  // namespace glissade
