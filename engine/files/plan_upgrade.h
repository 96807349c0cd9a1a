#pragma once

#include <nlohmann/json.hpp>

namespace glissade {

/// The document of a plan of version 1, in which a step was one motion, as version 2.
nlohmann::ordered_json upgradedPlan(nlohmann::ordered_json document);

}  // namespace glissade
