#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/model/missing_shape.h"

namespace glissade {

/// The shapes that a proof does not include, in the form of reports and path files.
nlohmann::ordered_json missingShapesJson(const MissingShapes& shapes);

}  // namespace glissade
