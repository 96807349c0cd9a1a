#pragma once

#include "app/window/workbench.h"

namespace glissade {

class PartImport;

/// The script commands about parts, where they and the ends of the motion are, and rules.
void addAssemblyCommands(const Workbench& bench, PartImport& parts);

}  // namespace glissade
