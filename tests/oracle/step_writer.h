#pragma once

#include <string>

#include "tests/oracle/trapped_pair.h"

namespace glissade::oracle {

/// Writes a solid of rings (millimetres) as a STEP file by OpenCASCADE: plane faces, or surfaces of revolution through
/// the rings' radii. Throws std::runtime_error.
void writeStep(const std::string& file, const std::vector<Ring>& rings, bool round);

/// The volume that the exact solids share when the object is lifted, cubic millimetres.
double commonVolume(const TrappedPair& pair, double lifted);

}  // namespace glissade::oracle
