#pragma once

#include <glissade/samplers.h>

#include "engine/planning/problem.h"

namespace glissade::api {

/// The source of the problem's random configurations, from a sampler from outside.
ConfigurationSource sourceOf(SamplerFunction sampler, const Problem& problem);

}  // namespace glissade::api
