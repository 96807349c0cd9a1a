#pragma once

#include "app/script/script_commands.h"

namespace glissade {

class ReplayController;

/// The script commands about recordings and replays.
void addReplayCommands(ScriptCommands& scripts, ReplayController& replay);

}  // namespace glissade
