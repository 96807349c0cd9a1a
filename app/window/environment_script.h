#pragma once

#include "app/window/workbench.h"

namespace glissade {

class EnvironmentController;

/// The script commands about places, attributes and the coarse plan.
void addEnvironmentCommands(const Workbench& bench, EnvironmentController& environment);

}  // namespace glissade
