#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/assembly/missing_shape.h"

namespace glissade {

/// As reports and path files state what a proof knows nothing of.
nlohmann::ordered_json missingShapesJson(const MissingShapes& shapes);

}  // namespace glissade
