#pragma once

#include <string>

#include "engine/fits/fit_settings.h"
#include "engine/model/body_id.h"

namespace glissade {

/// The statement of a person about this pair of bodies, by id in either order; adds an entry if there is none.
FitEdit& editOf(const BodyId& a, const BodyId& b, FitSettings& settings);

}  // namespace glissade
