#pragma once

#include <memory>

#include "engine/files/scenario.h"

namespace glissade {

/// A loaded scenario as it is shared between threads; it never changes.
using ScenarioPtr = std::shared_ptr<const LoadedScenario>;

}  // namespace glissade
