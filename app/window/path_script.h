#pragma once

#include "app/script/script_commands.h"

namespace glissade {

class PathController;

/// The script commands about the path that was found or given.
void addPathCommands(ScriptCommands& scripts, PathController& path);

}  // namespace glissade
